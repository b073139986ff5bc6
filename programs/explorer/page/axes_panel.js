// Which two parameters are the axes of the plane, and from where to where.
import {written} from './names.js';
import {shown, kind, parameter_names} from './shown.js';

export class AxesPanel {
    constructor(root, {viewed, chosen}) {
        Object.assign(this, {root, viewed, chosen});
    }

    show() {
        const {state} = shown, host = this.root.querySelector('div'), names = parameter_names();
        host.replaceChildren();
        this.root.hidden = names.length < 2;
        for (const which of ['x', 'y']) {
            const axis = state[which];
            if (!axis) continue;
            const select = document.createElement('select'), field = (k, label) => {
                const input = document.createElement('input');
                Object.assign(input, {type: 'number', step: 'any', value: Number(axis[k].toPrecision(6))});
                input.setAttribute('aria-label', label);
                input.addEventListener('change', () => {
                    const next = [...state[which]];
                    next[k] = Number(input.value);
                    if (next[1] < next[2]) this.viewed(which === 'x' ? next : state.x, which === 'y' ? next : state.y);
                });
                return input;
            };
            select.replaceChildren(...names.map(name => new Option(written(name, kind().labels), name, false, name === axis[0])));
            select.setAttribute('aria-label', which === 'x' ? 'across' : 'up');
            select.addEventListener('change', () => this.#choose(which, axis, select.value));
            host.append(which === 'x' ? 'across' : 'up', select, field(1, `${which} from`), 'to', field(2, `${which} to`));
        }
    }

    // If the other axis has it, they change places.
    #choose(which, axis, name) {
        const twin = which === 'x' ? 'y' : 'x', whole = name => [name, ...kind().range(name, shown.model.parameters[name])];
        const axes = {x: shown.state.x, y: shown.state.y, [which]: whole(name)};
        if (axes[twin][0] === name) axes[twin] = whole(axis[0]);
        this.chosen(axes);
    }
}
