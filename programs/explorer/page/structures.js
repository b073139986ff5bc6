// Two structures under load, with large rotations: a dome of trusses and a frame of beams, along all their branches. The shape is turned
// in space by three.js; the plot has load against displacement, with critical points to click.
import {
    AmbientLight, BufferGeometry, CatmullRomCurve3, Color, DirectionalLight, Float32BufferAttribute, LineBasicMaterial, LineSegments, Mesh,
    MeshStandardMaterial, PerspectiveCamera, Scene, SphereGeometry, TubeGeometry, Vector3, WebGLRenderer, Group,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {scale, tics, svg} from './axes.js';
import {colour} from './colours.js';
import {short, counted} from './names.js';

const structures = [
    ['star_dome', 'Star dome', 'A dome of 24 bars, loaded at its nodes: it snaps through, and buckles on the way.'],
    ['right_angle_frame', 'Right-angle frame', 'A thin frame, loaded in its plane: at a pitchfork it leaves the plane.'],
];
const margin = {left: 62, right: 14, top: 12, bottom: 44};
const words = {pitchfork: 'pitchfork', fold: 'fold', multiple: 'multiple bifurcation'};

class Structures {
    constructor(host, engine) {
        this.host = host;
        this.engine = engine;
        host.innerHTML = `<section class="panel" id="space-panel" aria-label="The structure in space"><div class="bar"><div class="choice" role="radiogroup" aria-label="Structure"></div></div>
            <div id="space"><canvas tabindex="0" role="img" aria-label="The loaded structure; drag to turn it"></canvas></div>
            <div class="walk"><button id="walk">▶ Along the branch</button><input type="range" min="0" step="1" aria-label="Place along the branch"></div>
            <p class="now" role="status"></p></section>
            <section class="panel" aria-label="Load and displacement"><div class="bar"><h2>All branches</h2><label class="pick">branch <select aria-label="Branch"></select></label></div>
            <div id="load-plot"><svg role="group" aria-label="Load against displacement"></svg></div>
            <div class="legend"></div><p class="status"></p></section>`;
        this.svg = host.querySelector('svg');
        this.range = host.querySelector('input');
        this.select = host.querySelector('select');
        this.choice = host.querySelector('.choice');
        this.choice.replaceChildren(...structures.map(([id, name]) => {
            const made = document.createElement('button');
            made.textContent = name;
            made.setAttribute('role', 'radio');
            made.dataset.id = id;
            made.addEventListener('click', () => this.open(id));
            return made;
        }));
        this.range.addEventListener('input', () => this.go(this.branch, Number(this.range.value)));
        this.select.addEventListener('change', () => this.go(Number(this.select.value), 0));
        host.querySelector('#walk').addEventListener('click', () => (this.walking ? this.stop() : this.walk()));
        this.#space();
        new ResizeObserver(() => this.draw()).observe(host.querySelector('#load-plot'));
        addEventListener('colours', () => this.draw());
        this.svg.addEventListener('click', event => this.#nearest(event));
        this.open('star_dome');
    }

    async open(id) {
        this.stop();
        for (const made of this.choice.children) made.setAttribute('aria-checked', made.dataset.id === id);
        const status = this.host.querySelector('.status'), hint = structures.find(s => s[0] === id)[2];
        document.querySelector('#hint').textContent = `${hint} Click a critical point, or move along a branch.`;
        status.textContent = 'Tracing all branches …';
        try {
            const {response, milliseconds} = await this.engine.run({command: 'structure', case: id}, {full: true});
            this.data = response;
            this.seconds = milliseconds / 1000;
        } catch (error) {
            status.textContent = error.message;
            return;
        }
        const {branches} = this.data, events = branches.flatMap(b => b.events).length;
        status.textContent = `${counted(branches.length, 'branch', 'branches')} and ${counted(events, 'critical point')}, traced in ${short(this.seconds, 2)} s.`;
        this.select.replaceChildren(...branches.map((b, k) => new Option(k === 0 ? 'fundamental' : `${k}, ${counted(b.events.length, 'critical point')}`, k)));
        this.#frame_space();
        const first = branches[0].events[0];
        this.go(0, first ? first.point : 0);
    }

    go(branch, point) {
        this.branch = branch;
        this.point = point;
        const {points, events} = this.data.branches[branch], here = points[point], event = events.find(e => e.point === point);
        this.select.value = branch;
        this.range.max = points.length - 1;
        this.range.value = point;
        this.host.querySelector('.now').textContent = `${event ? `${words[event.kind] ?? event.kind} at ` : ''}${this.data.parameter} = ${short(here.load, 6)}, displacement ${short(here.displacement, 5)}: ${event ? 'critical' : here.stable ? 'stable' : 'unstable'}`;
        this.#shape(here);
        this.draw();
    }
    walk() {
        this.walking = setInterval(() => {
            const last = this.data.branches[this.branch].points.length - 1;
            if (this.point >= last) return this.go(this.branch, 0);
            this.go(this.branch, this.point + 1);
        }, 70);
        this.host.querySelector('#walk').textContent = '■ Stop';
    }
    stop() {
        clearInterval(this.walking);
        this.walking = 0;
        this.host.querySelector('#walk').textContent = '▶ Along the branch';
    }

    // --- in space ---

    #space() {
        const canvas = this.host.querySelector('canvas');
        try {
            this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
        } catch {
            this.host.querySelector('#space').textContent = 'This browser has no WebGL, which the picture in space needs. The plot beside it works.';
            return;
        }
        this.scene = new Scene();
        this.camera = new PerspectiveCamera(32, 1, 0.01, 1e5);
        this.camera.up.set(0, 0, 1);
        const sun = new DirectionalLight(0xffffff, 1.6);
        sun.position.set(1, -2, 3);
        this.scene.add(new AmbientLight(0xffffff, 1.7), sun);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.addEventListener('change', () => this.#render());
        canvas.addEventListener('keydown', event => {
            const turn = {ArrowLeft: 0.12, ArrowRight: -0.12}[event.key];
            if (!turn) return;
            const {x, y} = this.camera.position.clone().sub(this.controls.target);
            this.camera.position.x = this.controls.target.x + x * Math.cos(turn) - y * Math.sin(turn);
            this.camera.position.y = this.controls.target.y + x * Math.sin(turn) + y * Math.cos(turn);
            this.controls.update();
            event.preventDefault();
        });
        new ResizeObserver(() => this.#render()).observe(canvas);
    }

    #frame_space() {
        if (!this.scene) return;
        this.still?.removeFromParent();
        this.body?.removeFromParent();
        const all = this.data.nodes.concat(this.data.branches.flatMap(b => b.points.filter((_, k) => k % 6 === 0).flatMap(p => p.shape)));
        const low = [0, 1, 2].map(i => Math.min(...all.map(p => p[i]))), high = [0, 1, 2].map(i => Math.max(...all.map(p => p[i])));
        this.size = Math.hypot(...high.map((h, i) => h - low[i]));
        const centre = new Vector3(...high.map((h, i) => (h + low[i]) / 2));
        const lines = [];
        for (const element of this.data.elements) for (let k = 0; k + 1 < element.length; ++k) lines.push(...this.data.nodes[element[k]], ...this.data.nodes[element[k + 1]]);
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', new Float32BufferAttribute(lines, 3));
        this.still = new LineSegments(geometry, new LineBasicMaterial());
        this.scene.add(this.still);
        this.controls.target.copy(centre);
        this.camera.position.copy(centre).add(new Vector3(0.5, -1.1, 0.55).multiplyScalar(this.size * 1.15));
        this.controls.update();
    }

    #shape({shape, stable}) {
        if (!this.scene) return;
        this.body?.traverse(part => part.geometry?.dispose());
        this.body?.removeFromParent();
        this.body = new Group();
        const material = new MeshStandardMaterial({color: new Color(colour(stable ? 'index-0' : 'index-2')), roughness: 0.55});
        const radius = this.size * (stable ? 0.0075 : 0.0045), joints = new Set();
        for (const element of this.data.elements) {
            const curve = new CatmullRomCurve3(element.map(n => new Vector3(...shape[n])));
            this.body.add(new Mesh(new TubeGeometry(curve, Math.max(1, 3 * (element.length - 1)), radius, 8), material));
            joints.add(element[0]).add(element.at(-1));
        }
        const ball = new SphereGeometry(radius * 1.5, 12, 8);
        for (const n of joints) {
            const joint = new Mesh(ball, material);
            joint.position.set(...shape[n]);
            this.body.add(joint);
        }
        this.scene.add(this.body);
        this.#render();
    }

    #render() {
        if (!this.scene || !this.still) return;
        const {clientWidth: width, clientHeight: height} = this.renderer.domElement;
        if (!width) return;
        this.still.material.color.set(colour('guide'));
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.renderer.render(this.scene, this.camera);
    }

    // --- the plot ---

    draw() {
        const {width, height} = this.svg.getBoundingClientRect();
        if (!width || !this.data) return;
        const points = this.data.branches.flatMap(b => b.points), {left, right, top, bottom} = margin;
        const span = key => {
            const values = points.map(p => p[key]), low = Math.min(...values), high = Math.max(...values);
            return [low - 0.04 * (high - low), high + 0.04 * (high - low)];
        };
        const sx = (this.sx = scale(span('displacement'), [left, width - right])), sy = (this.sy = scale(span('load'), [height - bottom, top]));
        this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        const frame = {x: left, y: top, width: width - left - right, height: height - top - bottom};
        const parts = [svg('rect', {...frame, class: 'paper'})];
        for (const {value, text} of tics(span('displacement'), 5)) parts.push(svg('path', {d: `M${sx(value)} ${height - bottom}v5`, class: 'tic'}), svg('text', {x: sx(value), y: height - bottom + 18, 'text-anchor': 'middle'}, text));
        for (const {value, text} of tics(span('load'), 5)) parts.push(svg('path', {d: `M${left} ${sy(value)}h-5`, class: 'tic'}), svg('text', {x: left - 8, y: sy(value) + 4, 'text-anchor': 'end'}, text));
        parts.push(svg('text', {x: (left + width - right) / 2, y: height - 6, 'text-anchor': 'middle'}, `displacement ${this.data.displacement}`),
            svg('text', {transform: `translate(12 ${height / 2}) rotate(-90)`, 'text-anchor': 'middle', class: 'name'}, this.data.parameter));
        this.data.branches.forEach((branch, k) => {
            // a branch that leaves a critical point is what its next point is
            const holds = i => (branch.points[i].stable || i === 0) && branch.points[i + 1].stable;
            for (let from = 0; from + 1 < branch.points.length; ) {
                let to = from + 1;
                const stable = holds(from);
                while (to + 1 < branch.points.length && holds(to) === stable) ++to;
                const d = branch.points.slice(from, to + 1).map((p, i) => `${i ? 'L' : 'M'}${sx(p.displacement).toFixed(1)} ${sy(p.load).toFixed(1)}`).join('');
                parts.push(svg('path', {d, class: stable ? 'branch stable' : 'branch', stroke: colour(stable ? 'index-0' : 'index-2'), opacity: k === this.branch ? 1 : 0.45}));
                from = to;
            }
        });
        const drawn = new Set();
        this.data.branches.forEach((branch, k) => branch.events.forEach(event => {
            const p = branch.points[event.point], x = sx(p.displacement), y = sy(p.load), key = `${event.kind} ${Math.round(x)} ${Math.round(y)}`;
            if (drawn.has(key)) return;
            drawn.add(key);
            const title = svg('title', {}, `${words[event.kind] ?? event.kind} at ${this.data.parameter} = ${short(event.load, 8)}`);
            const mark = svg('g', {class: 'critical', tabindex: 0, role: 'button', 'aria-label': title.textContent},
                svg('circle', {cx: x, cy: y, r: 11, fill: 'transparent'}),
                event.kind === 'fold' ? svg('rect', {x: x - 4, y: y - 4, width: 8, height: 8, fill: colour('ink')})
                    : event.kind === 'pitchfork' ? svg('circle', {cx: x, cy: y, r: 4.5, fill: colour('pitchfork')})
                        : svg('path', {d: `M${x} ${y - 6}l6 6l-6 6l-6 -6z`, fill: colour('arrow')}), title);
            const go = happened => {
                happened.stopPropagation();
                this.stop();
                this.go(k, event.point);
            };
            mark.addEventListener('click', go);
            mark.addEventListener('keydown', e => (e.key === 'Enter' || e.key === ' ') && go(e));
            parts.push(mark);
        }));
        const here = this.data.branches[this.branch].points[this.point];
        parts.push(svg('rect', {...frame, class: 'frame', 'pointer-events': 'none'}), svg('circle', {cx: sx(here.displacement), cy: sy(here.load), r: 8, class: 'choice', 'pointer-events': 'none'}));
        this.svg.replaceChildren(...parts);
        this.host.querySelector('.legend').innerHTML = '<span><svg viewBox="0 0 28 12"><path d="M0 6H28" stroke="var(--index-0)" stroke-width="3"/></svg>stable</span>'
            + '<span><svg viewBox="0 0 28 12"><path d="M0 6H28" stroke="var(--index-2)" stroke-width="1.5"/></svg>unstable</span>'
            + '<span><svg viewBox="0 0 28 12"><rect x="10" y="2" width="8" height="8" fill="var(--ink)"/></svg>folds</span>'
            + '<span><svg viewBox="0 0 28 12"><circle cx="14" cy="6" r="4.5" fill="var(--pitchfork)"/></svg>pitchforks</span>'
            + '<span><svg viewBox="0 0 28 12"><path d="M14 0l6 6l-6 6l-6 -6z" fill="var(--arrow)"/></svg>multiple bifurcations</span>';
    }

    #nearest(event) {
        const box = this.svg.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
        let best = [400, 0, 0];
        this.data?.branches.forEach((branch, k) => branch.points.forEach((p, i) => {
            const d = (this.sx(p.displacement) - x) ** 2 + (this.sy(p.load) - y) ** 2 - (k === this.branch ? 9 : 0);
            if (d < best[0]) best = [d, k, i];
        }));
        if (best[0] < 400) this.go(best[1], best[2]);
    }
}

// For the page: made when its tab is opened first.
window.equilibria_structures = (host, engine) => new Structures(host, engine);
