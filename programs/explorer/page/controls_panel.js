// The controls of a view: links, presets, parameters as sliders, the line, the legend, and which panels there are.
import {button, choices} from './controls.js';
import {slider} from './sliders.js';
import {written} from './names.js';
import {chain} from './chain.js';
import {own} from './own.js';
import {shown, kind, symbols, has_potential, parameter_names} from './shown.js';
import {$, panels} from './parts.js';

const key = (d, attributes, text) => `<span><svg viewBox="0 0 28 12" aria-hidden="true"><path d="${d}" ${attributes}/></svg>${text}</span>`;

export class ControlsPanel {
    constructor({opened, parameter_set, line_chosen}) {
        Object.assign(this, {opened, parameter_set, line_chosen});
    }

    show() {
        const {state} = shown, current = kind();
        panels.tabs.choose(current.id);
        $('#hint').textContent = current.hint;
        choices($('#links'), current === chain ? [1, 2, 3, 4, 5].map(n => [n, n === 1 ? '1 link' : String(n)]) : [], state.links, links => this.opened({view: 'chain', links}));
        $('#presets').replaceChildren(...current.presets.map(preset => button(preset.name, {title: preset.note}, () => this.opened({view: current.id, ...structuredClone(preset.state)}))));
        this.#show_sliders();
        choices($('#line'), [state.x?.[0], state.y?.[0]].filter(Boolean).map(name => [name, `along ${written(name, symbols())}`]), state.line, this.line_chosen);
        $('#show').replaceChildren(...shown.unknowns.map((name, i) => new Option(written(name, symbols()), i, false, i === state.show)));
        $('.pick').hidden = shown.unknowns.length < 2;
        panels.axes.show();
        $('#legend').innerHTML = key('M0 6H28', 'class="k-fold" stroke="var(--fold)" stroke-width="2.6"', 'folds')
            + key('M0 6H28', 'stroke="var(--pitchfork)" stroke-width="2.2" stroke-dasharray="7 3"', 'pitchforks')
            + key('M14 1.5a4.5 4.5 0 1 0 .01 0', 'fill="var(--ink)"', 'cusps')
            + (has_potential() ? '<span class="sum">under a count: stable + index 1 + index 2 + …</span>' : '');
        $('#legend').hidden = !state.x || !state.y;
        $('#own').hidden = current !== own;
        if (current === own && $('#text').value !== state.text) $('#text').value = state.text;
        $('#motion-panel').hidden = !current.motion;
        $('main').classList.toggle('moves', Boolean(current.motion));
        $('main').classList.toggle('own', current === own);
    }

    // The axes first.
    #show_sliders() {
        const {state} = shown, current = kind(), axes = [state.x, state.y].filter(Boolean), names = parameter_names();
        const ordered = [...axes.map(axis => axis[0]), ...names.filter(name => !axes.some(axis => axis[0] === name))];
        $('#sliders').replaceChildren(...ordered.map(name => {
            const axis = axes.find(a => a[0] === name), [low, high] = axis ? axis.slice(1) : current.range(name, shown.model.parameters[name]);
            const changed = (value, time) => this.parameter_set(name, value, time);
            const row = slider({name, label: written(name, current.labels), low, high, value: state.parameters[name], axis: Boolean(axis), changed});
            row.dataset.name = name;
            return row;
        }));
    }

    // The sliders of the axes reach as far as these now do.
    set_ranges(axes) {
        for (const [name, low, high] of axes) {
            const row = [...$('#sliders').children].find(r => r.dataset.name === name), range = row?.querySelector('[type=range]');
            if (range) [range.min, range.max] = [low, high];
        }
    }
    set_values(parameters) {
        for (const row of $('#sliders').children) row.set(parameters[row.dataset.name]);
    }
}
