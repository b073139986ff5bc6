// What can be saved: pictures with their styles inside, tables under the names of docs/output.md, and all of it as JSON.
const properties = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linecap', 'stroke-linejoin', 'opacity', 'font-size', 'font-family', 'font-style', 'font-weight', 'text-anchor', 'visibility'];

export function svg_text(element, {behind} = {}) {
    const copy = element.cloneNode(true), from = element.querySelectorAll('*'), to = copy.querySelectorAll('*');
    from.forEach((source, i) => {
        const style = getComputedStyle(source);
        if (to[i].closest('defs')) return;
        to[i].removeAttribute('class');
        for (const name of properties) {
            const value = style.getPropertyValue(name);
            if (value && !(name === 'opacity' && value === '1')) to[i].setAttribute(name, value);
        }
    });
    const {width, height} = element.getBoundingClientRect();
    copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
    copy.setAttribute('width', width);
    copy.setAttribute('height', height);
    if (behind) {
        const image = document.createElementNS('http://www.w3.org/2000/svg', 'image');
        for (const [key, value] of Object.entries({href: behind.toDataURL(), width, height})) image.setAttribute(key, value);
        copy.prepend(image);
    }
    const paper = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
    for (const [key, value] of Object.entries({width, height, fill: getComputedStyle(document.documentElement).getPropertyValue('--panel').trim()})) paper.setAttribute(key, value);
    copy.prepend(paper);
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + new XMLSerializer().serializeToString(copy) + '\n';
}

const cell = value => (value === null || value === undefined ? '' : value === true ? '1' : value === false ? '0' : /[",\n]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
export const csv = (header, rows) => [header, ...rows].map(row => row.map(cell).join(',')).join('\n') + '\n';

export function equilibria_csv(equilibria) {
    const n = equilibria[0] ? (equilibria[0].angles ?? []).length + (equilibria[0].coordinates ?? []).length : 0;
    const keys = ['index', 'nullity', 'multiplicity', 'stable', 'energy', 'residual', 'condition', 'margin', 'path'];
    return csv([...Array.from({length: n}, (_, i) => `q${i + 1}`), ...keys], equilibria.map(e => [...(e.angles ?? []), ...(e.coordinates ?? []), ...keys.map(k => e[k])]));
}

export function curves_csv(locus, x, y) {
    return csv(['curve', 'kind', x, y], locus.curves.flatMap((curve, k) => curve.points.map(p => [k, curve.kind, ...p])));
}

export function download(name, type, text) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
