// The text of a model of one's own: it is read while it is written, and a mistake is shown with its place.
import {Overtaken} from './engine.js';
import {button} from './controls.js';
import {own, offset_of} from './own.js';
import {live} from './parts.js';

export class OwnPanel {
    constructor(root, {opened}) {
        this.text = root.querySelector('#text');
        this.error = root.querySelector('#text-error');
        this.opened = opened;
        let timer = 0;
        this.text.addEventListener('input', () => {
            clearTimeout(timer);
            timer = setTimeout(() => this.#read(), 350);
        });
    }

    tell(error) {
        const offset = error.offset ?? offset_of(this.text.value, error.message);
        this.error.replaceChildren(error.message);
        this.text.setAttribute('aria-invalid', 'true');
        if (offset === null || offset === undefined) return;
        this.error.append(' ', button('Show the place', {}, () => {
            this.text.focus();
            this.text.setSelectionRange(offset, Math.min(offset + 1, this.text.value.length));
        }));
    }

    async #read() {
        const text = this.text.value;
        try {
            const parsed = own.model({text});
            await live.run({command: 'describe', model: parsed});
            this.error.textContent = '';
            this.text.removeAttribute('aria-invalid');
            this.opened({view: 'own', text});
        } catch (error) {
            if (!(error instanceof Overtaken)) this.tell(error);
        }
    }
}
