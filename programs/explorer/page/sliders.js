// A slider with a number beside it, for one parameter.
import {clamp} from './axes.js';

export function slider({name, label, low, high, value, axis = false, changed}) {
    const row = document.createElement('div');
    row.className = axis ? 'slider axis' : 'slider';
    const id = `slider-${name}`;
    row.innerHTML = `<label for="${id}"></label><input type="range" id="${id}" step="any"><input type="number" step="any">`;
    const [text, range, number] = row.children;
    text.textContent = label;
    number.setAttribute('aria-label', `${label}, as a number`);
    range.min = low;
    range.max = high;
    row.set = v => {
        range.value = clamp(v, low, high);
        if (document.activeElement !== number) number.value = Number(v.toPrecision(6));
    };
    row.set(value);
    range.addEventListener('input', event => {
        number.value = Number(Number(range.value).toPrecision(6));
        changed(Number(range.value), event.timeStamp);
    });
    range.addEventListener('keydown', event => {  // step "any" has none of its own
        const direction = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
        if (!direction) return;
        event.preventDefault();
        const v = clamp(Number(range.value) + direction * (high - low) * (event.shiftKey ? 0.05 : 0.005), low, high);
        row.set(v);
        number.value = Number(v.toPrecision(6));
        changed(v, event.timeStamp);
    });
    number.addEventListener('input', event => {
        const v = Number(number.value);
        if (number.value === '' || !Number.isFinite(v)) return;
        range.value = v;
        changed(v, event.timeStamp);
    });
    return row;
}
