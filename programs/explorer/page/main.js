// The page: what is shown (state), the three engines that compute it, and the panels that draw it.
//   live: the equilibria at the point; calm: what is asked once the point rests (proof, line); slow: curves of the plane.
import {Engine, Overtaken} from './engine.js';
import {Plane} from './plane.js';
import {Shapes} from './shapes.js';
import {Diagram} from './diagram.js';
import {Motion} from './motion.js';
import {slider} from './sliders.js';
import {matched} from './match.js';
import {clamp} from './axes.js';
import {index_word} from './colours.js';
import {written, short, counted} from './names.js';
import {by_index_in_words, change_in_words, proof_in_words, locus_in_words, line_in_words} from './words.js';
import {button, choices} from './controls.js';
import {address, read_address} from './state.js';
import {svg_text, equilibria_csv, curves_csv, download} from './save.js';
import {chain} from './chain.js';
import {mechanism} from './mechanism.js';
import {zeeman} from './zeeman.js';
import {own, offset_of} from './own.js';

const cases = {chain, mechanism, zeeman, own};
const $ = selector => document.querySelector(selector);
const live = new Engine(), calm = new Engine(), slow = new Engine();
const times = {first: null, drag: [], locus: null};
let structures = null;
let state, model, unknowns, angles, equilibria = [], solution = null, locus = null, diagram = null, proof = null;
let locus_key = '', diagram_key = '', rest_timer = 0, locus_timer = 0, moved_at = 0, generation = 0, diagram_time = 1e9;

const plane = new Plane($('#plane'), {moved: move_to, viewed: view});
const shapes = new Shapes($('#shapes'), {chosen: tell_chosen});
const line = new Diagram($('#diagram'), {moved: (value, time) => set_parameter(state.line, value, time)});
const motion = new Motion($('#motion-panel'), new Engine());
const kind = () => cases[state.view];
const symbols = () => ({...kind().labels, ...kind().symbols});
const has_potential = () => model.potential !== undefined;
const other_parameters = names => JSON.stringify(Object.entries(state.parameters).filter(([name]) => !names.includes(name)));

// --- what is shown -------------------------------------------------------------------------------------------------------------

function open(given, {keep_address = false} = {}) {
    const fresh = {...given};
    const start = cases[fresh.view].start({links: 2, ...fresh});
    state = {show: 0, ...start, ...fresh, parameters: {...start.parameters}};
    for (const [name, value] of Object.entries(fresh.parameters ?? {})) if (name in state.parameters) state.parameters[name] = value;
    const known = axis => (axis && axis[0] in state.parameters ? axis : undefined);
    state.x = known(state.x) ?? start.x;
    state.y = known(state.y) ?? start.y;
    if (state.x && state.y && state.x[0] === state.y[0]) [state.x, state.y] = [start.x, start.y];
    if (!(state.line in state.parameters)) state.line = start.line;
    structures?.stop();
    state.home = {x: state.x, y: state.y};
    ++generation;
    adopt_model();
    if (!keep_address) put_address();
}

// Everything after the model, its links or its axes have changed.
function adopt_model() {
    model = kind().model(state);
    unknowns = [...(model.angles ?? []), ...(model.coordinates ?? [])];
    angles = (model.angles ?? []).length;
    state.show = Math.min(state.show, Math.max(unknowns.length - 1, 0));
    equilibria = [];
    followed = null;
    live.quick = Infinity;
    $('#shapes').style.flexBasis = state.view === 'chain' && state.links > 3 ? (state.links === 4 ? '640px' : '820px') : '';
    solution = locus = diagram = proof = null;
    locus_key = diagram_key = '';
    for (const engine of [live, calm, slow]) if (engine.busy) engine.stop();
    plane.set_locus(null);
    plane.set_raster(null);
    line.set_samples(null);
    line.set_branches(null);
    $('#change').textContent = $('#locus-status').textContent = $('#diagram-status').textContent = '';
    $('#argument').hidden = $('#locus-stop').hidden = $('#locus-trace').hidden = true;
    $('#chosen').textContent = '';
    build_controls();
    frame();
    changed();
}

function frame() {
    const planar = Boolean(state.x && state.y);
    $('#plane').hidden = !planar;
    if (planar) plane.show({x: state.x, y: state.y, line: state.line, symbols: symbols()});
    $('#line-panel').hidden = !state.line;
    if (state.line) line.frame({range: line_range(), unknowns, angles, show: state.show, symbols: symbols(), potential: has_potential()});
}
const line_range = () => [state.x, state.y].find(axis => axis?.[0] === state.line) ?? [state.line, ...kind().range(state.line, state.parameters[state.line])];

function put_address() {
    history.replaceState(null, '', address(state));
}

// --- controls ------------------------------------------------------------------------------------------------------------------

function build_tabs() {
    const tabs = Object.values(cases).map(c => [c.id, c.tab]);
    if ($('#structures-script')) tabs.splice(3, 0, ['structures', 'Structures']);
    $('nav').replaceChildren(...tabs.map(([id, text]) => button(text, {role: 'tab', 'data-view': id}, () => (id === 'structures' ? open_structures() : open({view: id})))));
    $('nav').onkeydown = event => {
        const step = {ArrowRight: 1, ArrowLeft: -1}[event.key], all = [...$('nav').children];
        if (!step) return;
        const next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
        next.focus();
        next.click();
    };
}

function choose_tab(id) {
    for (const tab of $('nav').children) {
        tab.setAttribute('aria-selected', tab.dataset.view === id);
        tab.tabIndex = tab.dataset.view === id ? 0 : -1;
    }
    $('#structures').hidden = id !== 'structures';
    $('main:not(#structures)').hidden = id === 'structures';
}

function build_controls() {
    const current = kind();
    choose_tab(current.id);
    $('#hint').textContent = current.hint;
    choices($('#links'), current === chain ? [1, 2, 3, 4, 5].map(n => [n, n === 1 ? '1 link' : String(n)]) : [], state.links, links => open({view: 'chain', links}));
    $('#presets').replaceChildren(...current.presets.map(preset => button(preset.name, {title: preset.note}, () => open({view: current.id, ...structuredClone(preset.state)}))));
    const axes = [state.x?.[0], state.y?.[0]];
    const names = Object.keys(model.parameters ?? {}).filter(name => !current.hidden?.includes(name));
    const ordered = [...axes.filter(Boolean), ...names.filter(name => !axes.includes(name))];
    const host = $('#sliders');
    host.replaceChildren(...ordered.map(name => {
        const axis = [state.x, state.y].find(a => a?.[0] === name), [low, high] = axis ? axis.slice(1) : current.range(name, model.parameters[name]);
        const row = slider({name, label: written(name, current.labels), low, high, value: state.parameters[name], axis: Boolean(axis), changed: (value, time) => set_parameter(name, value, time)});
        row.dataset.name = name;
        return row;
    }));
    choices($('#line'), axes.filter(Boolean).map(name => [name, `along ${written(name, symbols())}`]), state.line, name => {
        state.line = name;
        diagram = null;
        diagram_key = '';
        calm.stop();
        line.set_branches(null);
        line.set_samples(null);
        build_controls();
        frame();
        changed();
    });
    $('#show').replaceChildren(...unknowns.map((name, i) => new Option(written(name, symbols()), i, false, i === state.show)));
    $('.pick').hidden = unknowns.length < 2;
    build_axes(names);
    const key = (d, attributes, text) => `<span><svg viewBox="0 0 28 12" aria-hidden="true"><path d="${d}" ${attributes}/></svg>${text}</span>`;
    $('#legend').innerHTML = key('M0 6H28', 'class="k-fold" stroke="var(--fold)" stroke-width="2.6"', 'folds')
        + key('M0 6H28', 'stroke="var(--pitchfork)" stroke-width="2.2" stroke-dasharray="7 3"', 'pitchforks')
        + key('M14 1.5a4.5 4.5 0 1 0 .01 0', 'fill="var(--ink)"', 'cusps')
        + (has_potential() ? '<span class="sum">12 = 2 + 6 + 4: stable + index 1 + index 2</span>' : '');
    $('#legend').hidden = !state.x || !state.y;
    $('#own').hidden = current !== own;
    if (current === own && $('#text').value !== state.text) $('#text').value = state.text;
    $('#motion-panel').hidden = !current.motion;
    $('main').classList.toggle('moves', Boolean(current.motion));
    $('main').classList.toggle('own', current === own);
}

function build_axes(names) {
    const host = $('#axes div');
    host.replaceChildren();
    $('#axes').hidden = names.length < 2;
    for (const which of ['x', 'y']) {
        const axis = state[which];
        if (!axis) continue;
        const select = document.createElement('select'), field = (k, label) => {
            const input = document.createElement('input');
            Object.assign(input, {type: 'number', step: 'any', value: Number(axis[k].toPrecision(6))});
            input.setAttribute('aria-label', label);
            input.addEventListener('change', () => {
                const next = [...state[which]];
                next[k] = Number(input.value);
                if (next[1] < next[2]) view(which === 'x' ? next : state.x, which === 'y' ? next : state.y);
            });
            return input;
        };
        select.replaceChildren(...names.map(name => new Option(written(name, kind().labels), name, false, name === axis[0])));
        select.setAttribute('aria-label', which === 'x' ? 'across' : 'up');
        select.addEventListener('change', () => {
            const name = select.value, twin = which === 'x' ? 'y' : 'x';
            const next = [name, ...kind().range(name, model.parameters[name])];
            if (state[twin][0] === name) state[twin] = [axis[0], ...kind().range(axis[0], model.parameters[axis[0]])];
            state[which] = next;
            state.line = state.y[0];
            state.home = {x: state.x, y: state.y};
            adopt_model();
            put_address();
        });
        host.append(which === 'x' ? 'across' : 'up', select, field(1, `${which} from`), 'to', field(2, `${which} to`));
    }
}

// --- what the reader does ------------------------------------------------------------------------------------------------------

function move_to([x, y], time) {
    state.parameters[state.x[0]] = x;
    state.parameters[state.y[0]] = y;
    changed(time);
}

function set_parameter(name, value, time) {
    state.parameters[name] = value;
    for (const axis of ['x', 'y'])
        if (state[axis]?.[0] === name && (value < state[axis][1] || value > state[axis][2])) {
            state[axis] = [name, Math.min(value, state[axis][1]), Math.max(value, state[axis][2])];
            frame();
        }
    changed(time);
}

// Another window of the plane; the curves are drawn where they now lie, and traced anew.
function view(x, y) {
    const fits = axis => {
        if (kind() === own || kind() === zeeman) return axis;
        const [low, high] = kind().range(axis[0]), least = axis[0] in {force: 1} ? -1e9 : Math.min(low, 0), most = axis[0] === 'alpha' ? 1 : high * 4;
        const width = Math.min(axis[2] - axis[1], most - least), from = clamp(axis[1], least, most - width);
        return [axis[0], from, from + width];
    };
    state.x = fits(x);
    state.y = fits(y);
    for (const axis of [state.x, state.y]) {
        const row = [...$('#sliders').children].find(r => r.dataset.name === axis[0]), range = row?.querySelector('[type=range]');
        if (range) [range.min, range.max] = axis.slice(1);
        state.parameters[axis[0]] = clamp(state.parameters[axis[0]], axis[1], axis[2]);
    }
    build_axes(Object.keys(model.parameters).filter(name => !kind().hidden?.includes(name)));
    frame();
    changed();
}

function changed(time = performance.now()) {
    moved_at = time;
    const at = state.x && state.y ? [state.parameters[state.x[0]], state.parameters[state.y[0]]] : null;
    if (at) plane.move(at);
    for (const row of $('#sliders').children) row.set(state.parameters[row.dataset.name]);
    solve(time);
    clearTimeout(rest_timer);
    rest_timer = setTimeout(rest, 180);
    const key = current_locus_key();
    if (key !== locus_key) {
        clearTimeout(locus_timer);
        if (locus && locus.key_of_parameters !== other_parameters([state.x[0], state.y[0]])) plane.set_locus(locus, true);
        locus_timer = setTimeout(trace_plane, locus ? 140 : 0);
    }
}
const current_locus_key = () => (state.x && state.y ? JSON.stringify([state.x, state.y, other_parameters([state.x[0], state.y[0]]), generation]) : '');

// --- the equilibria at the point -----------------------------------------------------------------------------------------------

async function solve(time) {
    const asked = generation, parameters = {...state.parameters}, began = performance.now();
    let answer;
    try {
        const request = {command: 'solve', model, set: parameters, prove: false};
        answer = live.run_here(request);
        if (!answer) {
            answer = await live.run(request);
            live.quick = answer.milliseconds;
        }
    } catch (error) {
        if (error instanceof Overtaken || asked !== generation) return;
        return fail(error);
    }
    if (asked !== generation) return;
    const before = solution?.by_index, answered = performance.now();
    solution = answer.response;
    solution.at = parameters;
    const found = solution.equilibria.map(e => ({...e, q: [...(e.angles ?? []), ...(e.coordinates ?? [])]}));
    if (found.length <= 300) equilibria = matched(equilibria, found, angles).sort((a, b) => a.index - b.index || a.id - b.id);
    else equilibria = found.map((e, i) => Object.assign(e, {id: i + 1, born: -1e9}));
    follow();
    const context = {angles, size: unknowns.length};
    shapes.show(equilibria, {
        sketch: q => kind().sketch({links: state.links}, q, parameters, context), extent: kind().extent(state, parameters, context), potential: has_potential(), followed: followed?.id,
        aspect: (([x0, x1, y0, y1]) => clamp((x1 - x0) / (y1 - y0), 0.6, 1.4))(kind().extent(state, parameters, context)),
    });
    $('#count strong').textContent = solution.real;
    $('#count .what').textContent = has_potential() ? `${solution.real === 1 ? 'equilibrium' : 'equilibria'}: ${by_index_in_words(solution.by_index)}` : solution.real === 1 ? 'equilibrium' : 'equilibria';
    tell_change(before, solution.by_index);
    if (state.x && state.y) plane.move([parameters[state.x[0]], parameters[state.y[0]]], point_in_words());
    if (state.line) line.now(parameters[state.line], equilibria, shapes.choice);
    tell_chosen(shapes.choice);
    if (proof && proof.at !== JSON.stringify(parameters)) {
        proof = null;
        $('#proof').innerHTML = '';
    }
    if (kind().motion) show_motion();
    const drawn = performance.now();
    times.drag.push({total: drawn - time, handled: drawn - began, answer: answered - began, engine: answer.milliseconds, drawing: drawn - answered});
    if (times.drag.length > 2000) times.drag.shift();
    times.solved = performance.now();
    if (times.first === null) requestAnimationFrame(() => (times.first ??= performance.now()));
    if (diagram_time < 250 && !calm.busy && line_key() !== diagram_key && drawn - line_started > 120) trace_line();
    else if (line_key() !== diagram_key) line.set_stale(true);
}

// The equilibrium that a machine rests in, until it is no more: then it jumps to another one.
let followed = null;
function follow() {
    if (!kind().follows) return;
    const stable = equilibria.filter(e => e.index === 0), was = equilibria.find(e => e.id === followed?.id);
    if (was && was.index === 0) return void (followed = was);
    const jump = followed !== null && stable.length > 0, away = e => Math.abs(Math.sin((e.q[0] - followed.q[0]) / 2));
    followed = jump ? [...stable].sort((a, b) => away(a) - away(b))[0] : stable[0] ?? null;
    if (jump) say_change('The equilibrium that held the disc is gone: it jumps.');
}

const point_in_words = () => `${[state.x[0], state.y[0]].map(name => `${written(name, symbols())} = ${short(state.parameters[name], 4)}`).join(', ')}: ${counted(solution.real, 'equilibrium', 'equilibria')}`;

let change_timer = 0, said_until = 0;
function tell_change(before, now) {
    const words = change_in_words(before, now);
    if (words && !(kind().follows && performance.now() < said_until - 3900)) say_change(words);  // a jump just told stands
}
function say_change(words) {
    $('#change').textContent = words;
    said_until = performance.now() + 4000;
    clearTimeout(change_timer);
    change_timer = setTimeout(() => ($('#change').textContent = ''), 4000);
}

function tell_chosen(choice) {
    if (state?.line) line.now(state.parameters[state.line], equilibria, choice);
    const host = $('#chosen');
    if (!choice) {
        host.textContent = '';
        return;
    }
    const place = unknowns.map((name, i) => `${written(name, symbols())} = ${short(choice.q[i], 7)}`).join(', ');
    host.textContent = `${has_potential() ? `${index_word(choice.index)}${choice.degenerate ? ', degenerate' : ''}: ` : ''}${place}${choice.energy !== null && choice.energy !== undefined ? `; energy ${short(choice.energy, 7)}` : ''}${choice.verdict ? `; the motion: ${choice.verdict}` : ''}`;
}

function fail(error) {
    equilibria = [];
    solution = null;
    shapes.show([], {sketch: () => ({}), extent: [-1, 1, -1, 1], potential: true});
    $('#count strong').textContent = '–';
    $('#count .what').textContent = state.view === 'own' ? 'no answer: see the message above' : error.message;
    $('#proof').textContent = '';
    if (state.view === 'own') tell_error(error);
}

// --- once the point rests: a proof, the line, the address ----------------------------------------------------------------------

async function rest() {
    put_address();
    fill_table();
    const asked = generation, at = JSON.stringify(state.parameters);
    if (calm.busy) calm.stop();
    $('#proof').textContent = 'proving …';
    try {
        const {response} = await calm.run({command: 'solve', model, set: state.parameters, prove: true});
        if (asked !== generation || at !== JSON.stringify(state.parameters)) return;
        proof = {...response.proof, at};
        tell_proof(response);
    } catch (error) {
        if (error instanceof Overtaken) return;
        $('#proof').textContent = `Not proved: ${error.message}`;
    }
    if (line_key() !== diagram_key) await trace_line();
}

function tell_proof(response) {
    const {mark, text} = proof_in_words(response), sign = document.createElement('span');
    sign.className = 'yes';
    sign.textContent = mark;
    $('#proof').replaceChildren(sign, ` ${text}`);
}

const line_key = () => (state.line ? JSON.stringify([line_range(), other_parameters([state.line]), generation]) : '');

let line_started = 0;
async function trace_line() {
    line_started = performance.now();
    const how = kind().diagram(state), range = line_range(), key = line_key(), asked = generation, [name, low, high] = range;
    const say = text => ($('#diagram-status').textContent = text);
    const set = {...state.parameters};
    try {
        if (how !== 'traced') {
            say('solving along the line …');
            const n = state.links >= 5 ? 90 : 160, samples = [];
            line.set_branches(null);
            // every fourth point first, so that the whole line is there at once
            const order = [0, 2, 1, 3].flatMap(first => Array.from({length: Math.ceil((n - first) / 4)}, (_, k) => first + 4 * k)).filter(k => k < n);
            await calm.sweep({command: 'solve', model, set, prove: false}, order.map(k => ({key: low + ((high - low) * (k + 0.5)) / n, set: {[name]: low + ((high - low) * (k + 0.5)) / n}})), rows => {
                samples.push(...rows);
                line.set_samples(samples);
            }, true);
            diagram_key = key;
            line.set_stale(false);
            say(`Solved at ${n} points of the line${how === 'both' ? '; tracing the branches …' : ', not traced'}.`);
        }
        if (how !== 'counted') {
            const {response, milliseconds} = await calm.run({command: 'diagram', model, set, vary: {name, low, high}}, {full: true});
            if (asked !== generation) return;
            diagram = response;
            diagram_key = key;
            diagram_time = milliseconds;
            line.set_branches(diagram);
            line.set_stale(key !== line_key());
            say(line_in_words(diagram));
        }
    } catch (error) {
        if (!(error instanceof Overtaken)) say(error.message);
    }
}

function fill_table() {
    if (!$('#table').open || !solution) return;
    const table = document.createElement('table');
    table.createTHead().innerHTML = `<tr><th>${['', ...unknowns.map(name => written(name, symbols())), 'index', 'energy', 'condition'].join('</th><th>')}</th></tr>`;
    const body = table.createTBody();
    equilibria.slice(0, 400).forEach((e, k) => {
        const row = body.insertRow();
        for (const value of [k + 1, ...e.q.map(v => short(v, 9)), `${e.index}${e.stable ? ' stable' : ''}`, short(e.energy ?? NaN, 8), short(e.condition, 2)]) row.insertCell().textContent = value;
    });
    $('#table div').replaceChildren(table);
}

// --- the plane -----------------------------------------------------------------------------------------------------------------

async function trace_plane(how = kind().locus(state)) {
    const key = current_locus_key(), asked = generation;
    if (!key) return;
    locus_key = key;
    slow.stop();
    const [nx, x0, x1] = state.x, [ny, y0, y1] = state.y, set = {...state.parameters}, say = text => ($('#locus-status').textContent = text);
    const parameters = other_parameters([nx, ny]), busy = on => ($('#locus-stop').hidden = !on);
    $('#locus-trace').hidden = true;
    $('#argument').hidden = true;
    try {
        busy(true);
        if (how !== 'traced' && how !== 'curves') {
            if (locus) plane.set_locus((locus = null));
            await count_plane(set, say);
        }
        if (how === 'counted') {
            busy(false);
            $('#locus-trace').hidden = false;
            const counts = [...plane.raster.cells.values()].map(c => c.count);
        return say(`Counted at points: from ${Math.min(...counts)} (light) to ${Math.max(...counts)} equilibria. The borders between the colours are not traced; that takes minutes.`);
        }
        const began = performance.now(), tracing = () => say(`Tracing the curves …${performance.now() - began > 2000 ? ` ${Math.round((performance.now() - began) / 1000)} s` : ''}`);
        tracing();
        const clock = setInterval(tracing, 1000);
        const {response, milliseconds} = await slow.run({command: 'locus', model, set, x: {name: nx, low: x0, high: x1}, y: {name: ny, low: y0, high: y1}}, {full: true}).finally(() => clearInterval(clock));
        if (asked !== generation) return;
        times.locus = milliseconds;
        locus = response;
        locus.key_of_parameters = parameters;
        plane.set_locus(locus);
        busy(false);
        tell_locus();
    } catch (error) {
        if (error instanceof Overtaken) return;
        busy(false);
        say(`${error.message[0]?.toUpperCase() ?? ''}${error.message.slice(1)}`);
        if (how === 'traced') {
            plane.set_locus((locus = null));
            try {
                busy(true);
                await count_plane(set, () => {});
                say(`Counted at points; curves were not traced: ${error.message}`);
            } catch { /* overtaken */ }
            busy(false);
        }
    }
}

async function count_plane(set, say) {
    const [nx, x0, x1] = state.x, [ny, y0, y1] = state.y, finest = state.links >= 5 ? 24 : state.links === 4 ? 48 : 36;
    const raster = {cells: new Map()};
    for (const n of [8, 16, finest].filter((v, k, all) => all.indexOf(v) === k)) {
        const wide = (x1 - x0) / n, high = (y1 - y0) / n, points = [];
        for (let j = 0; j < n; ++j)
            for (let i = 0; i < n; ++i) {
                const x = x0 + (i + 0.5) * wide, y = y0 + (j + 0.5) * high;
                points.push({key: {x, y, wide, high}, set: {[nx]: x, [ny]: y}});
            }
        say(`Counting equilibria at ${n} × ${n} points …`);
        await slow.sweep({command: 'solve', model, set, prove: false}, points, rows => {
            for (const {key, by_index, count} of rows) if (by_index) raster.cells.set(`${n} ${key.x} ${key.y}`, {...key, count, by_index});
            plane.set_raster(raster);
        });
    }
    for (const [key, cell] of raster.cells) if (cell.wide > 1.01 * (x1 - x0) / finest) raster.cells.delete(key);
    plane.set_raster(raster);
}

function tell_locus() {
    $('#locus-status').textContent = locus_in_words(locus, times.locus);
    $('#argument').hidden = false;
    $('#argument p').textContent = locus.argument;
}

// --- the model of one's own ----------------------------------------------------------------------------------------------------

let text_timer = 0;
function tell_error(error) {
    const offset = error.offset ?? offset_of($('#text').value, error.message), host = $('#text-error');
    host.replaceChildren(error.message);
    $('#text').setAttribute('aria-invalid', 'true');
    if (offset === null || offset === undefined) return;
    host.append(' ', button('Show the place', {}, () => {
        $('#text').focus();
        $('#text').setSelectionRange(offset, Math.min(offset + 1, $('#text').value.length));
    }));
}
async function read_text() {
    const text = $('#text').value;
    try {
        const parsed = own.model({text});
        await live.run({command: 'describe', model: parsed});
        $('#text-error').textContent = '';
        $('#text').removeAttribute('aria-invalid');
        open({view: 'own', text});
    } catch (error) {
        if (!(error instanceof Overtaken)) tell_error(error);
    }
}
$('#text').addEventListener('input', () => {
    clearTimeout(text_timer);
    text_timer = setTimeout(read_text, 350);
});

// --- motions and structures ----------------------------------------------------------------------------------------------------

function show_motion() {
    const parameters = {...state.parameters}, current = kind();
    motion.show({
        model, set: parameters, unknowns, labels: symbols(), motion: current.motion, equilibria,
        sketch: q => current.sketch(state, q, parameters, {}), extent: current.extent(state, parameters, {}),
    });
}

function open_structures() {
    for (const engine of [live, calm, slow]) engine.stop();
    clearTimeout(rest_timer);
    clearTimeout(locus_timer);
    ++generation;
    choose_tab('structures');
    history.replaceState(null, '', '#structures');
    if (structures) return void structures.open(structures.data?.case ?? 'star_dome');
    const script = document.createElement('script');
    script.textContent = $('#structures-script').textContent;
    document.body.append(script);
    structures = window.equilibria_structures($('#structures'), new Engine());
}

// --- saving --------------------------------------------------------------------------------------------------------------------

async function saved(what) {
    const name = model.name?.replace(/[^\w]+/g, '_') ?? 'model';
    if (what === 'plane-svg') return [`${name}_plane.svg`, 'image/svg+xml', svg_text($('#plane svg'), {behind: !locus && plane.raster ? $('#plane canvas') : undefined})];
    if (what === 'diagram-svg') return [`${name}_diagram.svg`, 'image/svg+xml', svg_text($('#diagram svg'))];
    if (what === 'equilibria-csv') return [`${name}_equilibria.csv`, 'text/csv', equilibria_csv(solution?.equilibria ?? [])];
    if (what === 'curves-csv') return locus ? [`${name}_curves.csv`, 'text/csv', curves_csv(locus, state.x[0], state.y[0])] : null;
    const engine = new Engine(), {response} = await engine.run({command: 'solve', model, set: state.parameters, prove: true}, {full: true}).finally(() => setTimeout(() => engine.stop()));
    return [`${name}.json`, 'application/json', JSON.stringify({model, address: address(state), solution: response, locus, diagram}, null, 2)];
}
for (const made of document.querySelectorAll('[data-save]'))
    made.addEventListener('click', async () => {
        const file = await saved(made.dataset.save);
        if (file) download(...file);
        else $('#locus-status').textContent = 'No curves are traced yet.';
    });
$('#share').addEventListener('click', async () => {
    put_address();
    try {
        await navigator.clipboard.writeText(location.href);
        $('#share').textContent = 'Copied';
    } catch {
        $('#share').textContent = 'The address bar has it';
    }
    setTimeout(() => ($('#share').textContent = 'Copy the address'), 2000);
});

// --- the rest ------------------------------------------------------------------------------------------------------------------

$('#show').addEventListener('change', () => {
    state.show = Number($('#show').value);
    frame();
    put_address();
});
$('#zoom-in').addEventListener('click', () => plane.zoom(0.5));
$('#zoom-out').addEventListener('click', () => plane.zoom(2));
$('#zoom-home').addEventListener('click', () => {
    const start = kind().start(state);
    view(start.x ?? state.home.x, start.y ?? state.home.y);
});
$('#locus-stop').addEventListener('click', () => {
    slow.stop();
    $('#locus-stop').hidden = true;
    $('#locus-status').textContent = 'Stopped.';
    $('#locus-trace').hidden = false;
});
$('#locus-trace').addEventListener('click', () => trace_plane('curves'));
$('#table').addEventListener('toggle', fill_table);

function open_address() {
    const given = read_address(location.hash);
    if (given?.view === 'structures' && $('#structures-script')) return open_structures();
    try {
        open(given && cases[given.view] ? given : {view: 'chain', links: 2}, {keep_address: !given});
    } catch (error) {  // a model that does not read, in an address
        open({view: 'own'});
        $('#text').value = given.text ?? '';
        tell_error(error);
    }
}
addEventListener('hashchange', open_address);
build_tabs();
open_address();

// For tests: what is shown, and how long it took.
window.explorer = {
    get state() { return state; }, get model() { return model; }, get solution() { return solution; }, get locus() { return locus; }, get diagram() { return diagram; }, get proof() { return proof; },
    get equilibria() { return equilibria; }, times, open, move_to, saved,
};
