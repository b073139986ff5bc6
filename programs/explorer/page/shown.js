// What is shown: one object that all parts of the page read, and what follows from it alone.
import {chain} from './chain.js';
import {mechanism} from './mechanism.js';
import {body} from './body.js';
import {zeeman} from './zeeman.js';
import {own} from './own.js';
import {address} from './state.js';

export const cases = {chain, mechanism, body, zeeman, own};

export const shown = {
    state: null, model: null, unknowns: [], angles: 0,         // what is asked: a view, as the address holds it, and the model that it makes
    equilibria: [], solution: null, followed: null,            // at the point; the equilibrium that a machine rests in
    proof: null, diagram: null, diagram_key: '',               // at rest; the line and the parameters that the diagram is of
    locus: null, locus_key: '',                                // of the plane
    generation: 0,                                             // of views: what an older one has asked for is dropped
};

export const kind = () => cases[shown.state.view];
export const symbols = () => ({...kind().labels, ...kind().symbols});
export const has_potential = () => shown.model.potential !== undefined || shown.model.study !== undefined;
export const parameter_names = () => Object.keys(shown.model.parameters ?? {}).filter(name => !kind().hidden?.includes(name));

export function line_range() {
    const {state} = shown;
    return [state.x, state.y].find(axis => axis?.[0] === state.line) ?? [state.line, ...kind().range(state.line, state.parameters[state.line])];
}

// What curves depend on; they are traced anew when it is another one.
export const other_parameters = names => JSON.stringify(Object.entries(shown.state.parameters).filter(([name]) => !names.includes(name)));
export const line_key = () => (shown.state.line ? JSON.stringify([line_range(), other_parameters([shown.state.line]), shown.generation]) : '');
export function current_locus_key() {
    const {x, y} = shown.state;
    return x && y ? JSON.stringify([x, y, other_parameters([x[0], y[0]]), shown.generation]) : '';
}

export function put_address() {
    history.replaceState(null, '', address(shown.state));
}
