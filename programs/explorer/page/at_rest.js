// Once the point rests: a proof, the line through it, the address, the table of the equilibria.
import {Overtaken} from './engine.js';
import {written, short} from './names.js';
import {proof_in_words, line_in_words} from './words.js';
import {shown, kind, symbols, line_range, line_key, put_address} from './shown.js';
import {$, calm, panels} from './parts.js';

export async function rest() {
    put_address();
    fill_table();
    const {parameters} = shown.state, asked = shown.generation, at = JSON.stringify(parameters);
    if (calm.busy) calm.stop();
    $('#proof').textContent = 'proving …';
    try {
        const {response} = await calm.run({command: 'solve', model: shown.model, set: parameters, prove: true});
        if (asked !== shown.generation || at !== JSON.stringify(shown.state.parameters)) return;
        shown.proof = {...response.proof, at};
        tell_proof(response);
    } catch (error) {
        if (error instanceof Overtaken) return;
        $('#proof').textContent = `Not proved: ${error.message}`;
    }
    if (line_key() !== shown.diagram_key) await trace_line();
}

function tell_proof(response) {
    const {mark, text} = proof_in_words(response), sign = document.createElement('span');
    sign.className = 'yes';
    sign.textContent = mark;
    $('#proof').replaceChildren(sign, ` ${text}`);
}

let line_started = 0, line_took = 1e9;
const say = text => ($('#diagram-status').textContent = text);

// While the point moves: another line is traced at once where that has been quick, and waits for the point to rest otherwise.
export function follow_line(now) {
    if (line_key() === shown.diagram_key) return;
    if (line_took < 250 && !calm.busy && now - line_started > 120) trace_line();
    else panels.line.set_stale(true);
}

async function trace_line() {
    line_started = performance.now();
    const {state} = shown, how = kind().diagram(state), [name, low, high] = line_range(), key = line_key(), asked = shown.generation, set = {...state.parameters};
    try {
        if (how !== 'traced') {
            const n = await count_line({set, name, low, high});
            shown.diagram_key = key;
            panels.line.set_stale(false);
            say(`Solved at ${n} points of the line${how === 'both' ? '; tracing the branches …' : ', not traced'}.`);
        }
        if (how !== 'counted') {
            const {response, milliseconds} = await calm.run({command: 'diagram', model: shown.model, set, vary: {name, low, high}}, {full: true});
            if (asked !== shown.generation) return;
            shown.diagram = response;
            shown.diagram_key = key;
            line_took = milliseconds;
            panels.line.set_branches(response);
            panels.line.set_stale(key !== line_key());
            say(line_in_words(response));
        }
    } catch (error) {
        if (!(error instanceof Overtaken)) say(error.message);
    }
}

async function count_line({set, name, low, high}) {
    say('solving along the line …');
    const n = shown.state.links >= 5 ? 90 : 160, samples = [];
    panels.line.set_branches(null);
    // every fourth point first, so that the whole line is there at once
    const order = [0, 2, 1, 3].flatMap(first => Array.from({length: Math.ceil((n - first) / 4)}, (_, k) => first + 4 * k)).filter(k => k < n);
    const points = order.map(k => low + ((high - low) * (k + 0.5)) / n).map(value => ({key: value, set: {[name]: value}}));
    await calm.sweep({command: 'solve', model: shown.model, set, prove: false}, points, rows => {
        samples.push(...rows);
        panels.line.set_samples(samples);
    }, true);
    return n;
}

export function fill_table() {
    if (!$('#table').open || !shown.solution) return;
    const table = document.createElement('table');
    table.createTHead().innerHTML = `<tr><th>${['', ...shown.unknowns.map(name => written(name, symbols())), 'index', 'energy', 'condition'].join('</th><th>')}</th></tr>`;
    const body = table.createTBody();
    shown.equilibria.slice(0, 400).forEach((e, k) => {
        const row = body.insertRow();
        for (const value of [k + 1, ...e.q.map(v => short(v, 9)), `${e.index}${e.stable ? ' stable' : ''}`, short(e.energy ?? NaN, 8), short(e.condition, 2)]) row.insertCell().textContent = value;
    });
    $('#table div').replaceChildren(table);
}
