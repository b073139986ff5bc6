// The tabs: one a case, and one for structures where the page has them.
import {button} from './controls.js';
import {cases} from './shown.js';
import {$} from './parts.js';

export class Tabs {
    constructor(host, {opened}) {
        this.host = host;
        const tabs = Object.values(cases).map(c => [c.id, c.tab]);
        if ($('#structures-script')) tabs.splice(-1, 0, ['structures', 'Structures']);
        host.replaceChildren(...tabs.map(([id, text]) => button(text, {role: 'tab', 'data-view': id}, () => opened(id))));
        host.onkeydown = event => {
            const step = {ArrowRight: 1, ArrowLeft: -1}[event.key], all = [...host.children];
            if (!step) return;
            const next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
            next.focus();
            next.click();
        };
    }

    choose(id) {
        for (const tab of this.host.children) {
            tab.setAttribute('aria-selected', tab.dataset.view === id);
            tab.tabIndex = tab.dataset.view === id ? 0 : -1;
        }
        $('#structures').hidden = id !== 'structures';
        $('main:not(#structures)').hidden = id === 'structures';
    }
}
