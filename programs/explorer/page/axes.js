// Scales from a parameter's range to pixels, and where their tics stand.
export const tau = 2 * Math.PI;

export function scale([low, high], [from, to]) {
    const s = (to - from) / (high - low);
    const map = value => from + (value - low) * s;
    map.back = pixel => low + (pixel - from) / s;
    return map;
}

export function tics([low, high], wanted = 5) {
    const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].find(f => f * power >= raw * 0.999) * power;
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const found = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
        found.push({value: k * step, text: (k * step).toFixed(Math.min(digits, 12)).replace('-', '−').replace(/^−(0(\.0*)?)$/, '$1')});
    return found;
}

export const angle_tics = [[-Math.PI, '−π'], [-Math.PI / 2, '−π/2'], [0, '0'], [Math.PI / 2, 'π/2'], [Math.PI, 'π']].map(([value, text]) => ({value, text}));
export const wrapped = angle => angle - tau * Math.round(angle / tau);
export const clamp = (value, low, high) => Math.min(high, Math.max(low, value));

export function svg(name, attributes = {}, ...children) {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) if (value !== undefined) element.setAttribute(key, value);
    element.append(...children);
    return element;
}
