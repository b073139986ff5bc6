// The equilibria at the point: solved at each move, and all that tells of them.
import {Overtaken} from './engine.js';
import {matched} from './match.js';
import {clamp} from './axes.js';
import {index_word} from './colours.js';
import {written, short, counted} from './names.js';
import {by_index_in_words, change_in_words} from './words.js';
import {shown, kind, symbols, has_potential} from './shown.js';
import {$, put, live, panels, times} from './parts.js';
import {follow_line} from './at_rest.js';

export async function solve(time) {
    const asked = shown.generation, parameters = {...shown.state.parameters}, began = performance.now();
    let answer;
    try {
        const request = {command: 'solve', model: shown.model, set: parameters, prove: false};
        answer = live.run_here(request);
        if (!answer) {
            answer = await live.run(request);
            live.quick = answer.milliseconds;
        }
    } catch (error) {
        if (error instanceof Overtaken || asked !== shown.generation) return;
        return fail(error);
    }
    if (asked !== shown.generation) return;
    const before = shown.solution?.by_index, answered = performance.now();
    adopt(answer.response, parameters);
    show_shapes(parameters);
    tell(before, parameters);
    const drawn = performance.now();
    times.drag.push({total: drawn - time, handled: drawn - began, answer: answered - began, engine: answer.milliseconds, drawing: drawn - answered});
    if (times.drag.length > 2000) times.drag.shift();
    times.solved = performance.now();
    if (times.first === null) requestAnimationFrame(() => (times.first ??= performance.now()));
    follow_line(drawn);
}

function adopt(solution, parameters) {
    shown.solution = solution;
    solution.at = parameters;
    const found = solution.equilibria.map(e => ({...e, q: [...(e.angles ?? []), ...(e.coordinates ?? [])]}));
    if (found.length <= 300) shown.equilibria = matched(shown.equilibria, found, shown.angles).sort((a, b) => a.index - b.index || a.id - b.id);
    else shown.equilibria = found.map((e, i) => Object.assign(e, {id: i + 1, born: -1e9}));
    follow();
}

// The equilibrium that a machine rests in, until it is no more: then it jumps to another one.
function follow() {
    if (!kind().follows) return;
    const {equilibria, followed} = shown, stable = equilibria.filter(e => e.index === 0), was = equilibria.find(e => e.id === followed?.id);
    if (was && was.index === 0) return void (shown.followed = was);
    const jump = followed !== null && stable.length > 0, away = e => Math.abs(Math.sin((e.q[0] - followed.q[0]) / 2));
    shown.followed = jump ? [...stable].sort((a, b) => away(a) - away(b))[0] : stable[0] ?? null;
    if (jump) say_change('The equilibrium that held the disc is gone: it jumps.');
}

function show_shapes(parameters) {
    const {state, angles, unknowns} = shown, context = {angles, size: unknowns.length, equilibria: shown.equilibria}, extent = kind().extent(state, parameters, context), [x0, x1, y0, y1] = extent;
    panels.shapes.show(shown.equilibria, {
        sketch: q => kind().sketch({links: shown.state.links}, q, parameters, context), extent, potential: has_potential(), followed: shown.followed?.id,
        aspect: clamp((x1 - x0) / (y1 - y0), 0.6, 1.4),
    });
}

function tell(before, parameters) {
    const {state, solution} = shown, what = solution.real === 1 ? 'equilibrium' : 'equilibria';
    put($('#count strong'), String(solution.real));
    put($('#count .what'), has_potential() ? `${what}: ${by_index_in_words(solution.by_index)}` : what);
    tell_change(before, solution.by_index);
    if (state.x && state.y) panels.plane.say(point_in_words());
    tell_chosen(panels.shapes.choice);
    if (shown.proof && shown.proof.at !== JSON.stringify(parameters)) {
        shown.proof = null;
        $('#proof').innerHTML = '';
    }
    if (kind().motion) show_motion(parameters);
}

function point_in_words() {
    const {state, solution} = shown, place = [state.x[0], state.y[0]].map(name => `${written(name, symbols())} = ${short(state.parameters[name], 4)}`).join(', ');
    return `${place}: ${counted(solution.real, 'equilibrium', 'equilibria')}`;
}

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

export function tell_chosen(choice) {
    const {state, unknowns, equilibria} = shown, host = $('#chosen');
    if (state?.line) panels.line.now(state.parameters[state.line], equilibria, choice);
    if (!choice) return put(host, '');
    const place = unknowns.map((name, i) => `${written(name, symbols())} = ${short(choice.q[i], 7)}`).join(', ');
    const index = has_potential() ? `${index_word(choice.index)}${choice.degenerate ? ', degenerate' : ''}: ` : '';
    const energy = choice.energy !== null && choice.energy !== undefined ? `; energy ${short(choice.energy, 7)}` : '';
    host.textContent = `${index}${place}${energy}${choice.verdict ? `; the motion: ${choice.verdict}` : ''}`;
}

function show_motion(parameters) {
    const {state, model, unknowns, equilibria} = shown, current = kind(), set = {...parameters};
    panels.motion.show({
        model, set, unknowns, labels: symbols(), motion: current.motion, equilibria,
        sketch: q => current.sketch(state, q, set, {}), extent: current.extent(state, set, {equilibria: shown.equilibria}),
    });
}

function fail(error) {
    const written_here = shown.state.view === 'own';
    shown.equilibria = [];
    shown.solution = null;
    panels.shapes.show([], {sketch: () => ({}), extent: [-1, 1, -1, 1], potential: true});
    $('#count strong').textContent = '–';
    $('#count .what').textContent = written_here ? 'no answer: see the message above' : error.message;
    $('#proof').textContent = '';
    if (written_here) panels.own.tell(error);
}
