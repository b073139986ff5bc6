// A view is opened: its model, its axes, its controls; what the last one has asked for is dropped.
import {cases, shown, kind, put_address} from './shown.js';
import {$, panels, engines, live, calm} from './parts.js';
import {read_address} from './state.js';
import {frame, changed} from './moves.js';
import {open_structures, stop_structures} from './structures_tab.js';

export function open(given, {keep_address = false} = {}) {
    const fresh = {...given}, start = cases[fresh.view].start({links: 2, ...fresh});
    const state = (shown.state = {show: 0, ...start, ...fresh, parameters: {...start.parameters}});
    for (const [name, value] of Object.entries(fresh.parameters ?? {})) if (name in state.parameters) state.parameters[name] = value;
    const known = axis => (axis && axis[0] in state.parameters ? axis : undefined);
    state.x = known(state.x) ?? start.x;
    state.y = known(state.y) ?? start.y;
    if (state.x && state.y && state.x[0] === state.y[0]) [state.x, state.y] = [start.x, start.y];
    if (!(state.line in state.parameters)) state.line = start.line;
    stop_structures();
    state.home = {x: state.x, y: state.y};
    ++shown.generation;
    adopt_model();
    if (!keep_address) put_address();
}

// Everything after the model, its links or its axes have changed.
function adopt_model() {
    const {state} = shown, model = kind().model(state);
    const unknowns = [...(model.angles ?? []), ...(model.coordinates ?? [])];
    Object.assign(shown, {
        model, unknowns, angles: (model.angles ?? []).length, equilibria: [], solution: null, followed: null, proof: null, diagram: null, diagram_key: '', locus: null, locus_key: '',
    });
    state.show = Math.min(state.show, Math.max(unknowns.length - 1, 0));
    live.quick = Infinity;
    $('#shapes').style.flexBasis = kind().room?.(state) ?? '';
    for (const engine of engines) if (engine.busy) engine.stop();
    panels.plane.set_locus(null);
    panels.plane.set_raster(null);
    panels.line.set_samples(null);
    panels.line.set_branches(null);
    $('#change').textContent = $('#locus-status').textContent = $('#diagram-status').textContent = '';
    $('#argument').hidden = $('#locus-stop').hidden = $('#locus-trace').hidden = true;
    $('#chosen').textContent = '';
    if (kind().wait) {
        $('#count strong').textContent = '…';
        $('#count .what').textContent = kind().wait;
    }
    panels.controls.show();
    frame();
    changed();
}

// Other axes of the same view.
export function choose_axes({x, y}) {
    Object.assign(shown.state, {x, y, line: y[0], home: {x, y}});
    adopt_model();
    put_address();
}

// Another line through the point.
export function choose_line(name) {
    shown.state.line = name;
    shown.diagram = null;
    shown.diagram_key = '';
    calm.stop();
    panels.line.set_branches(null);
    panels.line.set_samples(null);
    panels.controls.show();
    frame();
    changed();
}

// The view that the address holds; two links if it holds none.
export function open_address() {
    const given = read_address(location.hash);
    if (given?.view === 'structures' && $('#structures-script')) return open_structures();
    try {
        open(given && cases[given.view] ? given : {view: 'chain', links: 2}, {keep_address: !given});
    } catch (error) {  // a model that does not read, in an address
        open({view: 'own'});
        $('#text').value = given.text ?? '';
        panels.own.tell(error);
    }
}
