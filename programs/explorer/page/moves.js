// What the reader moves: the point, a parameter, the window of the plane; and what is asked of the engines then.
import {clamp} from './axes.js';
import {shown, kind, symbols, has_potential, line_range, current_locus_key, other_parameters} from './shown.js';
import {$, panels} from './parts.js';
import {solve} from './at_point.js';
import {rest} from './at_rest.js';
import {trace_plane} from './plane_curves.js';

let rest_timer = 0, locus_timer = 0;

export function move_to([x, y], time) {
    const {state} = shown;
    state.parameters[state.x[0]] = x;
    state.parameters[state.y[0]] = y;
    changed(time);
}

export function set_parameter(name, value, time) {
    const {state} = shown;
    state.parameters[name] = value;
    for (const axis of ['x', 'y'])
        if (state[axis]?.[0] === name && (value < state[axis][1] || value > state[axis][2])) {
            state[axis] = [name, Math.min(value, state[axis][1]), Math.max(value, state[axis][2])];
            frame();
        }
    changed(time);
}

// Another window of the plane; the curves are drawn where they now lie, and traced anew.
export function view(x, y) {
    const {state} = shown, fits = axis => {
        const [least, most] = kind().limits?.(axis[0]) ?? [-Infinity, Infinity];
        const width = Math.min(axis[2] - axis[1], most - least), from = clamp(axis[1], least, most - width);
        return [axis[0], from, from + width];
    };
    state.x = fits(x);
    state.y = fits(y);
    panels.controls.set_ranges([state.x, state.y]);
    for (const [name, low, high] of [state.x, state.y]) state.parameters[name] = clamp(state.parameters[name], low, high);
    panels.axes.show();
    frame();
    changed();
}

// The axes of the plane and of the diagram.
export function frame() {
    const {state, unknowns, angles} = shown, planar = Boolean(state.x && state.y);
    $('#plane').hidden = !planar;
    if (planar) panels.plane.show({x: state.x, y: state.y, line: state.line, symbols: symbols()});
    $('#line-panel').hidden = !state.line;
    if (state.line) panels.line.frame({range: line_range(), unknowns, angles, show: state.show, symbols: symbols(), potential: has_potential()});
}

export function changed(time = performance.now()) {
    const {state, locus} = shown;
    if (state.x && state.y) panels.plane.move([state.parameters[state.x[0]], state.parameters[state.y[0]]]);
    panels.controls.set_values(state.parameters);
    solve(time);
    clearTimeout(rest_timer);
    rest_timer = setTimeout(rest, 180);
    if (current_locus_key() === shown.locus_key) return;
    clearTimeout(locus_timer);
    if (locus && locus.key_of_parameters !== other_parameters([state.x[0], state.y[0]])) panels.plane.set_locus(locus, true);
    locus_timer = setTimeout(trace_plane, locus ? 140 : 0);
}

// Nothing is asked any more.
export function forget_timers() {
    clearTimeout(rest_timer);
    clearTimeout(locus_timer);
}
