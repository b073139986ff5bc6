// Buttons, and rows of buttons of which one is chosen.
export function button(text, attributes, act) {
    const made = document.createElement('button');
    made.textContent = text;
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.addEventListener('click', act);
    return made;
}

// options: [value, text] each; arrow keys go from one to the next.
export function choices(host, options, chosen, act) {
    host.replaceChildren(...options.map(([value, text]) =>
        button(text, {role: 'radio', 'aria-checked': value === chosen, tabindex: value === chosen ? 0 : -1}, () => act(value))));
    host.onkeydown = event => {
        const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
        if (!step) return;
        event.preventDefault();
        const next = options[(options.findIndex(o => o[0] === chosen) + step + options.length) % options.length][0];
        act(next);
        host.querySelector('[aria-checked=true]')?.focus();
    };
}
