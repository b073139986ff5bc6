// The engine as a page has it: its answers are those of the program `equilibria`, within rounding; its errors; its memory and times.
//
//   node engine_test.mjs ENGINE.wasm EQUILIBRIA [--no-times]
//
// EQUILIBRIA is that program, compiled without EQUILIBRIA_NATIVE: fused operations round once where WebAssembly rounds twice.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

const [engineFile, program, ...options] = process.argv.slice(2);
if (!engineFile || !program) {
    console.error("usage: engine_test.mjs ENGINE.wasm EQUILIBRIA [--no-times]");
    process.exit(2);
}
const timed = !options.includes("--no-times");
const here = path.dirname(fileURLToPath(import.meta.url));
const models = path.join(here, "../../../examples/models");
const chain = path.join(here, "rotating_chain_of_four_links.json");
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "engine_test"));

const module = new WebAssembly.Module(fs.readFileSync(engineFile));

/// An instance with as little of a system as a page gives it: a clock, and what it prints.
class Engine {
    constructor() {
        const badFile = 8;
        const own = {
            clock_time_get: (clock, precision, at) => {
                this.view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
                return 0;
            },
            environ_get: () => 0,
            environ_sizes_get: (count, size) => {
                this.view().setUint32(count, 0, true);
                this.view().setUint32(size, 0, true);
                return 0;
            },
            fd_write: (file, list, count, written) => {
                let size = 0;
                for (let k = 0; k < count; k++) {
                    const at = this.view().getUint32(list + 8 * k, true), bytes = this.view().getUint32(list + 8 * k + 4, true);
                    process.stderr.write(this.text(at, bytes));
                    size += bytes;
                }
                this.view().setUint32(written, size, true);
                return 0;
            },
            proc_exit: (status) => {
                throw new Error(`exit ${status}`);
            },
        };
        const imports = { wasi_snapshot_preview1: {} };
        for (const { module: from, name } of WebAssembly.Module.imports(module)) {
            if (from !== "wasi_snapshot_preview1") throw new Error(`imports ${from}.${name}`);
            imports[from][name] = own[name] ?? (() => badFile);
        }
        this.exports = new WebAssembly.Instance(module, imports).exports;
        this.exports._initialize();
    }
    view() {
        return new DataView(this.exports.memory.buffer);
    }
    text(at, bytes) {
        return Buffer.from(this.exports.memory.buffer, at, bytes).toString();
    }
    ended(at) {
        return this.text(at, new Uint8Array(this.exports.memory.buffer).indexOf(0, at) - at);
    }
    run(request) {
        const bytes = Buffer.from(JSON.stringify(request));
        const at = this.exports.engine_alloc(bytes.length);
        new Uint8Array(this.exports.memory.buffer).set(bytes, at);
        let response;
        try {
            response = this.exports.engine_run(at, bytes.length);
        } catch (trap) {
            throw new Error(this.ended(this.exports.engine_error()) || `trap: ${trap.message}`);
        }
        this.exports.engine_free(at);
        return this.ended(response);
    }
    bytes() {
        return this.exports.memory.buffer.byteLength;
    }
}

let failed = 0;
function check(good, what) {
    if (!good) failed++;
    console.log(`${good ? "ok  " : "FAIL"} ${what}`);
}
function model(name) {
    return JSON.parse(fs.readFileSync(name.includes("/") ? name : path.join(models, name)));
}
function native(...words) {
    // a motion that is stopped ends with status 1, after its document
    const y = spawnSync(program, words, { encoding: "utf8", maxBuffer: 1 << 28 });
    return y.stdout;
}
const untimed = (text) => text.replace(/^ *"[a-z_]*seconds": .*\n/gm, "").trimEnd();

// What rounding decides: how far Newton's method came, how many steps paths took, whether a start system was tried again, and
// which of two mirror images is told.
const rounding = /attempts|residual|correction|condition|steps|seconds|in_double|null_vector|third_derivative|slope|balance|evaluations|retracked/;
/// The first place where two documents differ by more than rounding; nothing where there is none.
function difference(a, b, place = "") {
    if (rounding.test(place)) return undefined;
    if (typeof a === "number" && typeof b === "number") {
        const mirrored = place.includes("events") && /angles|coordinates/.test(place);
        const [x, y] = mirrored ? [Math.abs(a), Math.abs(b)] : [a, b];
        if (/angles|roots/.test(place) && Math.abs(Math.abs(x - y) - 2 * Math.PI) < 1e-7) return undefined;
        return Math.abs(x - y) <= 1e-7 * Math.max(1, Math.abs(x)) ? undefined : `${place}: ${a} and ${b}`;
    }
    if (a && b && typeof a === "object" && typeof b === "object") {
        const keys = Object.keys(a);
        if (keys.join() !== Object.keys(b).join()) return `${place}: ${keys.length} and ${Object.keys(b).length} members`;
        for (const key of keys) {
            const found = difference(a[key], b[key], `${place}.${key}`);
            if (found) return found;
        }
        return undefined;
    }
    if (typeof a === "string" && typeof b === "string") {
        const once = (text) => text.replace(/ \(start system [^)]*\)/g, "");
        return once(a) === once(b) ? undefined : `${place}: ${a} and ${b}`;
    }
    return a === b ? undefined : `${place}: ${a} and ${b}`;
}
function same(what, response, expected) {
    if (untimed(response) === untimed(expected)) return check(true, `${what}: the same bytes`);
    let found = "one is no JSON";
    try {
        found = difference(JSON.parse(expected), JSON.parse(response));
    } catch {}
    check(!found, `${what}: ${found ?? "the same within rounding"}`);
}

// Equilibria of all models, with proofs
const files = fs.readdirSync(models).filter((name) => name.endsWith(".json")).map((name) => path.join(models, name));
let engine = new Engine();
for (const file of [...files, chain]) {
    const what = path.basename(file, ".json");
    same(`solve ${what}`, engine.run({ command: "solve", model: model(file), file }), native("solve", file, "--json", "-"));
    same(
        `prove ${what}`,
        engine.run({ command: "solve", model: model(file), file, prove: true, seed: 3 }),
        native("prove", file, "--seed", "3", "--json", "-"),
    );
}
const pendulumFile = path.join(models, "rotating_double_pendulum.json"), pendulum = model(pendulumFile);
same(
    "solve, parameters set",
    engine.run({ command: "solve", model: pendulum, file: pendulumFile, set: { omega: 3, alpha: 0.4 } }),
    native("solve", pendulumFile, "--set", "omega=3,alpha=0.4", "--json", "-"),
);
const described = JSON.parse(engine.run({ command: "describe", model: pendulum }));
check(described.angles.join() === "t1,t2" && described.parameters.alpha === 0.33 && described.has_potential && !described.moves,
    "describe");

// Lines, planes, motion
same(
    "events",
    engine.run({ command: "events", model: pendulum, file: pendulumFile, vary: { name: "omega", low: 0, high: 5 } }),
    native("events", pendulumFile, "--vary", "omega=0:5", "--json", "-"),
);
same(
    "diagram",
    engine.run({ command: "diagram", model: pendulum, file: pendulumFile, vary: { name: "omega", low: 0, high: 4 } }),
    native("diagram", pendulumFile, "--vary", "omega=0:4", "--json", "-"),
);
const plane = {
    command: "locus",
    model: pendulum,
    file: pendulumFile,
    x: { name: "alpha", low: 0, high: 1 },
    y: { name: "omega", low: 0, high: 5 },
};
same("locus", engine.run(plane), native("locus", pendulumFile, "--x", "alpha=0:1", "--y", "omega=0:5", "--json", "-"));
const springFile = path.join(models, "elastic_pendulum.json");
const motion = { command: "motion", model: model(springFile), file: springFile, until: 5, points: 11 };
const [angle] = model(springFile).angles, [coordinate] = model(springFile).coordinates;
same(
    "motion",
    engine.run({ ...motion, start: { [angle]: 0.3, [coordinate]: 1 } }),
    native("motion", springFile, "--start", `${angle}=0.3,${coordinate}=1`, "--until", "5", "--points", "11", "--json", "-"),
);

// Structures: their critical loads are known (docs/finite-rotations.md)
for (const [name, kind, load, branches] of [["star_dome", "pitchfork", 0.00086436745, 9], ["right_angle_frame", "pitchfork", 1.08752, 3]]) {
    const found = JSON.parse(engine.run({ command: "structure", case: name }));
    const [first] = found.branches[0].events;
    check(first.kind === kind && Math.abs(first.load / load - 1) < 1e-5 && found.branches.length === branches,
        `${name}: ${first.kind} at ${first.load}, ${found.branches.length} branches`);
    const wrong = found.branches.flatMap(({ points, events }) => [
        ...points.filter((point) => point.shape.length !== found.nodes.length),
        ...events.filter((event) => points[event.point].load !== event.load),
    ]);
    check(wrong.length === 0, `${name}: a shape at each point, and a point at each event`);
}

// A body with a beam: as the program body_beam, and a count of branches that fits its counts
const body = {
    study: "body_beam",
    parameters: {
        body_mass: 2, inertia_1: 1.2, inertia_2: 1.3, inertia_3: 0.8, length: 1, bending_1: 1, bending_2: 1.2, stretching: 100,
        momentum: 9, coupling: 0, damping: 0.3,
    },
};
for (const [momentum, coupling] of [[4, 0], [9, 0], [6, 1]]) {
    const found = JSON.parse(engine.run({ command: "solve", model: body, set: { momentum, coupling }, prove: true }));
    const strain = coupling ? "coupled" : "linear";
    const words = ["--modes", "1", "--momentum", String(momentum), "--strain", strain, "--prove", "--json", "-"];
    const expected = JSON.parse(spawnSync(path.join(path.dirname(program), "body_beam"), words, { encoding: "utf8" }).stdout);
    const place = ({ axis, modes, moment, speed }) => [...axis, ...modes, moment, speed];
    const near = (p, q) => p.every((x, i) => Math.abs(x - q[i]) < 1e-7);
    check(found.equilibria.length === expected.equilibria.length && expected.equilibria.every((e) =>
        found.equilibria.some((own) => own.index === e.index && near(own.coordinates, place(e)))),
    `body_beam at momentum ${momentum}, ${strain}: ${found.real} equilibria, as the program has them`);
    check(found.proof.proved === expected.proved_distinct && found.distinct === expected.distinct, `body_beam: ${found.proof.proved} proved`);
}
const branches = JSON.parse(engine.run({ command: "diagram", model: body, vary: { name: "momentum", low: 3, high: 9 } }));
for (const momentum of [4.1, 6.1, 8.9]) {
    const counts = [0, 0, 0, 0, 0, 0];
    for (const { index, points } of branches.branches) if ((points[0][0] - momentum) * (points.at(-1)[0] - momentum) < 0) counts[index]++;
    const { by_index } = JSON.parse(engine.run({ command: "solve", model: body, set: { momentum } }));
    check(branches.complete && counts.join() === by_index.join(), `body_beam: branches by index at momentum ${momentum}: ${counts}`);
}
const settled = JSON.parse(engine.run({ command: "motion", model: body, set: { momentum: 7 }, start: { tilt: 1 }, until: 60, points: 61 }));
check(settled.status === "finished" && settled.largest_balance < 1e-8 && settled.momentum_drift < 1e-8 &&
    settled.points.every(({ momentum }) => Math.abs(Math.hypot(...momentum) - 7) < 1e-7),
`body_beam: the motion keeps its momentum, energy balanced to ${settled.largest_balance}`);

// Errors
function error(request) {
    try {
        new Engine().run(request);
    } catch (caught) {
        return caught.message;
    }
    return "none";
}
function nativeError(text) {
    const file = path.join(scratch, "model.json");
    fs.writeFileSync(file, text);
    return spawnSync(program, ["solve", file], { encoding: "utf8" }).stderr.trim().replace(`equilibria solve: ${file}: `, "");
}
for (const [potential, what] of [
    ["cos(t1) + sin(t2", "a parenthesis missing"],
    ["cos(t1*t2)", "a product of angles"],
    ["cos(t1) + unknown*cos(t2)", "an unknown name"],
    ["cos(t1)/cos(t2)", "a divisor"],
    ["cos(t1) + 1e999", "a number too large"],
]) {
    const text = JSON.stringify({ ...pendulum, potential }, null, 2);
    const said = error({ command: "solve", model: text });
    check(said === nativeError(text), `wrong formula, ${what}: ${said}`);
}
check(/potential, line 1, column 8 = /.test(error({ command: "describe", model: { ...pendulum, potential: "cos(t1 *t2)" } })),
    `line and column in the formula: ${error({ command: "describe", model: { ...pendulum, potential: "cos(t1 *t2)" } })}`);
check(nativeError('{"angles": ["a"], "potential": }') === error({ command: "solve", model: '{"angles": ["a"], "potential": }' }),
    "a text that is no JSON");
for (const [request, expected] of [
    [{ command: "dance", model: pendulum }, /command = dance: must be one of/],
    [{ command: "solve" }, /must have "model"/],
    [{ command: "solve", model: pendulum, colour: 1 }, /colour = 1: is no key of solve/],
    [{ command: "solve", model: pendulum, set: { mass: 1 } }, /mass.*must be/],
    [{ command: "events", model: pendulum, vary: { name: "omega", low: 1, high: 1 } }, /low < high/],
    [{ command: "motion", model: pendulum }, /does not move/],
    [{ command: "solve", model: { study: "dance", parameters: {} } }, /model.study = "dance": must be "body_beam"/],
    [{ command: "events", model: body }, /must be one of solve, diagram, locus, motion/],
    [{ command: "solve", model: body, set: { inertia_3: 9 } }, /inertia = 9: must be at most/],
    [{ command: "solve", model: body, set: { coupling: 0.5 } }, /coupling = 0.5: must be 0 or 1/],
    [{ command: "diagram", model: body, vary: { name: "length", low: 1, high: 2 } }, /must be momentum/],
    [{ command: "locus", model: body, x: { name: "length", low: 1, high: 2 }, y: { name: "body_mass", low: 1, high: 2 } }, /must be momentum/],
]) {
    const said = error(request);
    check(expected.test(said), `refused: ${said}`);
}

// Memory of an instance that is called over and over
engine = new Engine();
const followed = (k) => engine.run({ command: "solve", model: pendulum, set: { omega: 1 + (k % 100) * 0.03 } });
for (let k = 0; k < 200; k++) followed(k);
const before = engine.bytes();
for (let k = 0; k < 1000; k++) followed(k);
check(engine.bytes() === before, `memory after 1,200 calls: ${engine.bytes()} bytes, after 200 of them ${before}`);

// Times
function milliseconds(calls, run) {
    const y = [];
    for (let k = 0; k < calls; k++) {
        const begin = performance.now();
        run(k);
        y.push(performance.now() - begin);
    }
    return y.sort((a, b) => a - b)[Math.floor(calls / 2)];
}
if (timed) {
    engine = new Engine();
    const cold = milliseconds(1, followed);
    for (let k = 0; k < 50; k++) followed(k);
    const two = milliseconds(100, followed);
    const links = model(chain);
    const four = (k) => engine.run({ command: "solve", model: links, set: { omega: 1.7 + k * 0.01 } });
    for (let k = 0; k < 10; k++) four(k);
    const fourth = milliseconds(30, four);
    engine = new Engine();
    const locus = milliseconds(1, () => engine.run(plane));
    console.log(`times: first call ${cold.toFixed(1)} ms; n = 2 ${two.toFixed(2)} ms, n = 4 ${fourth.toFixed(1)} ms, medians; ` +
        `locus of two links ${(locus / 1000).toFixed(2)} s`);
    check(two < 16, "n = 2 in less than a frame of 16 ms");
    check(fourth < 100, "n = 4 in less than 100 ms");
    check(locus < 5000, "the locus of two links in less than 5 s");
}
console.log(`engine.wasm: ${fs.statSync(engineFile).size} bytes`);
fs.rmSync(scratch, { recursive: true });
if (failed) console.log(`${failed} FAILED`);
process.exit(failed ? 1 : 0);
