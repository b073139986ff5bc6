// The tab of structures: a script of its own, read when it is opened first.
import {Engine} from './engine.js';
import {shown} from './shown.js';
import {$, engines, panels} from './parts.js';
import {forget_timers} from './moves.js';

let structures = null;

export function open_structures() {
    for (const engine of engines) engine.stop();
    forget_timers();
    ++shown.generation;
    panels.tabs.choose('structures');
    history.replaceState(null, '', '#structures');
    if (structures) return void structures.open(structures.data?.case ?? 'star_dome');
    const script = document.createElement('script');
    script.textContent = $('#structures-script').textContent;
    document.body.append(script);
    structures = window.equilibria_structures($('#structures'), new Engine());
}

export function stop_structures() {
    structures?.stop();
}
