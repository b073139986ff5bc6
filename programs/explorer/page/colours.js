// The colours of docs/images: by index, of curves, of regions. Read from the style sheet, so that dark mode has its own.
const root = () => getComputedStyle(document.documentElement);
let cache = {};
export const colour = name => (cache[name] ??= root().getPropertyValue(`--${name}`).trim());
export const index_colour = index => colour(`index-${Math.min(index, 5)}`);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    cache = {};
    dispatchEvent(new Event('colours'));
});

// A tint for the k-th of n different counts, the smallest count first.
export function tint(k, n) {
    const [from, to] = [colour('tint-few'), colour('tint-many')].map(c => c.match(/[\da-f]{2}/gi).map(h => parseInt(h, 16)));
    const t = n > 1 ? k / (n - 1) : 0;
    return '#' + from.map((a, i) => Math.round(a + (to[i] - a) * t).toString(16).padStart(2, '0')).join('');
}
export const index_word = index => (index === 0 ? 'stable' : `index ${index}`);
