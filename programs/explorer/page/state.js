// What the page shows, as the part of its address behind #: a view can be shared by its address.
//   #chain&links=2&x=alpha:0:1&y=omega:0:5&line=omega&alpha=0.33&omega=1.8
const packed = text => btoa(String.fromCharCode(...new TextEncoder().encode(text))).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
const unpacked = text => new TextDecoder().decode(Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0)));
const number = value => String(Number(value.toPrecision(12)));

export function address(state) {
    const parts = [state.view];
    if (state.view === 'chain') parts.push(`links=${state.links}`);
    if (state.x) parts.push(`x=${state.x.join(':')}`);
    if (state.y) parts.push(`y=${state.y.join(':')}`);
    if (state.line) parts.push(`line=${state.line}`);
    if (state.show) parts.push(`show=${state.show}`);
    for (const [name, value] of Object.entries(state.parameters)) parts.push(`p.${name}=${number(value)}`);
    if (state.view === 'own' && state.text) parts.push(`model=${packed(state.text)}`);
    return '#' + parts.join('&');
}

// The state of an address; what does not read is left to the defaults.
export function read_address(hash) {
    const [view, ...parts] = hash.replace(/^#/, '').split('&');
    if (!view) return null;
    const state = {view, parameters: {}};
    for (const part of parts) {
        const at = part.indexOf('='), key = part.slice(0, at), value = decodeURIComponent(part.slice(at + 1));
        if (key === 'x' || key === 'y') {
            const [name, low, high] = value.split(':');
            if (Number(low) < Number(high)) state[key] = [name, Number(low), Number(high)];
        } else if (key === 'links') {
            state.links = Math.min(5, Math.max(1, Math.round(Number(value)) || 2));
        } else if (key === 'show') {
            state.show = Math.max(0, Number(value) || 0);
        } else if (key === 'line') {
            state.line = value;
        } else if (key === 'model') {
            try {
                state.text = unpacked(value);
            } catch { /* a cut-off address: the example */ }
        } else if (key.startsWith('p.') && Number.isFinite(Number(value))) {
            state.parameters[key.slice(2)] = Number(value);
        }
    }
    return state;
}
