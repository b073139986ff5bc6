// The plane of two parameters: regions, curves, cusps, and the point that is dragged. Wheel, pinch and the keys + and - zoom.
import {scale, tics, svg, clamp} from './axes.js';
import {colour, tint} from './colours.js';
import {short, written} from './names.js';
import {counted_regions} from './counted.js';

const margin = {left: 54, right: 14, top: 12, bottom: 44};

export class Plane {
    constructor(host, {moved, viewed}) {
        this.host = host;
        this.moved = moved;
        this.viewed = viewed;
        this.canvas = host.querySelector('canvas');
        this.svg = host.querySelector('svg');
        this.layers = {};
        for (const name of ['back', 'fill', 'curves', 'labels', 'front', 'point']) this.svg.append((this.layers[name] = svg('g', {class: name})));
        this.layers.clip = svg('clipPath', {id: 'window'}, svg('rect'));
        this.svg.prepend(svg('defs', {}, this.layers.clip));
        for (const name of ['fill', 'curves', 'labels']) this.layers[name].setAttribute('clip-path', 'url(#window)');
        this.#build_point();
        new ResizeObserver(() => this.#fit()).observe(host);
        addEventListener('colours', () => this.draw());
        this.#listen();
    }

    // {x: [name, low, high], y, symbols}; keeps the locus, which is drawn where it now lies.
    show(axes) {
        this.axes = axes;
        this.#fit();
    }
    set_locus(locus, stale = false) {
        this.locus = locus;
        this.stale = stale;
        this.draw();
    }
    set_raster(raster) {
        this.raster = raster;
        this.#draw_raster();
    }

    #fit() {
        if (!this.axes) return;
        const {width, height} = this.host.getBoundingClientRect();
        if (!width || !height) return;
        this.size = [width, height];
        this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        const {left, right, top, bottom} = margin;
        this.box = [left, width - right, height - bottom, top];
        const [, x0, x1] = this.axes.x, [, y0, y1] = this.axes.y;
        this.sx = scale([x0, x1], [left, width - right]);
        this.sy = scale([y0, y1], [height - bottom, top]);
        this.draw();
    }

    draw() {
        if (!this.box) return;
        this.#draw_frame();
        this.#draw_locus();
        this.#draw_raster();
        this.move(this.at);
    }

    #draw_frame() {
        const [left, right, bottom, top] = this.box, {back, front, clip} = this.layers;
        const [nx, x0, x1] = this.axes.x, [ny, y0, y1] = this.axes.y, {symbols} = this.axes;
        const frame = {x: left, y: top, width: right - left, height: bottom - top};
        for (const [key, value] of Object.entries(frame)) clip.firstChild.setAttribute(key, value);
        this.handle.setAttribute('aria-valuemin', x0);
        this.handle.setAttribute('aria-valuemax', x1);
        this.lines[0].classList.toggle('cut', this.axes.line === nx);
        this.lines[1].classList.toggle('cut', this.axes.line !== nx);
        back.replaceChildren(svg('rect', {...frame, class: 'paper'}));
        front.replaceChildren(svg('rect', {...frame, class: 'frame'}));
        for (const {value, text} of tics([x0, x1], this.size[0] < 480 ? 4 : 6)) {
            const x = this.sx(value);
            front.append(svg('path', {d: `M${x} ${bottom}v5`, class: 'tic'}), svg('text', {x, y: bottom + 19, 'text-anchor': 'middle'}, text));
        }
        for (const {value, text} of tics([y0, y1], 6)) {
            const y = this.sy(value);
            front.append(svg('path', {d: `M${left} ${y}h-5`, class: 'tic'}), svg('text', {x: left - 9, y: y + 4, 'text-anchor': 'end'}, text));
        }
        front.append(
            svg('text', {x: (left + right) / 2, y: bottom + 38, 'text-anchor': 'middle', class: 'name'}, written(nx, symbols)),
            written(ny, symbols).length < 3 ? svg('text', {x: 2, y: (top + bottom) / 2 + 5 - (bottom - top) / 24, class: 'name'}, written(ny, symbols))
                : svg('text', {transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle', class: 'name'}, written(ny, symbols)));
    }

    #path(points, closed = false) {
        let d = '';
        for (let i = 0; i < points.length; ++i) d += `${i ? 'L' : 'M'}${this.sx(points[i][0]).toFixed(2)} ${this.sy(points[i][1]).toFixed(2)}`;
        return closed ? d + 'Z' : d;
    }

    #draw_locus() {
        const {fill, curves, labels} = this.layers;
        for (const layer of [fill, curves, labels]) layer.replaceChildren();
        this.svg.classList.toggle('stale', Boolean(this.stale));
        const locus = this.locus;
        if (!locus) return;
        const [nx] = this.axes.x, [ny] = this.axes.y;
        const counts = [...new Set(locus.regions.map(r => r.count))].sort((a, b) => a - b);
        locus.regions.forEach(region => {
            const colour = tint(counts.indexOf(region.count), counts.length);
            fill.append(svg('path', {d: region.polygons.map(p => this.#path(p, true)).join(''), fill: colour, stroke: colour, 'stroke-width': 0.8}));
        });
        for (const kind of ['pitchfork', 'fold'])
            for (const curve of locus.curves.filter(c => c.kind === kind))
                curves.append(svg('path', {d: this.#path(curve.points), class: kind, stroke: colour(kind)}));
        for (const cusp of locus.cusps)
            curves.append(svg('circle', {cx: this.sx(cusp[nx]), cy: this.sy(cusp[ny]), r: 4.5, class: 'cusp'},
                svg('title', {}, `cusp: ${written(nx)} = ${short(cusp[nx], 10)}, ${written(ny)} = ${short(cusp[ny], 10)}`)));
        for (const p of locus.degenerate_pitchforks ?? [])
            curves.append(svg('rect', {x: this.sx(p[nx]) - 3.5, y: this.sy(p[ny]) - 3.5, width: 7, height: 7, class: 'cusp'}, svg('title', {}, 'degenerate pitchfork')));
        this.#label(this.#places());
    }

    #label(places) {
        for (const {region, x, y, room} of places) {
            if (room < 9) continue;
            const by_index = region.by_index.slice(0, region.by_index.findLastIndex(n => n > 0) + 1).join(' + ');
            const size = clamp(room * 0.8, 12, 24), both = room > 19 && Math.min(x - this.box[0], this.box[1] - x) > 3.4 * by_index.length;
            const text = svg('text', {x, y: y + size * (both ? 0.18 : 0.35), 'text-anchor': 'middle', class: 'count', style: `font-size: ${size.toFixed(1)}px`}, String(region.count));
            this.layers.labels.append(text);
            if (both) this.layers.labels.append(svg('text', {x, y: y + size * 0.18 + 15, 'text-anchor': 'middle', class: 'by-index'}, by_index));
        }
    }

    // Points of the curves, close together.
    #walls() {
        const [left, right, bottom, top] = this.box, walls = [];
        for (const curve of this.locus?.curves ?? []) {
            let last = null;
            for (const [x, y] of curve.points) {
                const p = [this.sx(x), this.sy(y)];
                if (last && Math.max(p[0], last[0]) > left && Math.min(p[0], last[0]) < right && Math.max(p[1], last[1]) > top && Math.min(p[1], last[1]) < bottom)
                    for (let s = 0, n = Math.ceil(Math.hypot(p[0] - last[0], p[1] - last[1]) / 8); s < n; ++s)
                        walls.push([last[0] + (p[0] - last[0]) * s / n, last[1] + (p[1] - last[1]) * s / n]);
                last = p;
            }
        }
        return walls;
    }
    // How far (x, y) is from curves and borders; no more than `enough` where that is less.
    #room(x, y, walls, enough) {
        const [left, right, bottom, top] = this.box;
        let room = Math.min(x - left, right - x, y - top, bottom - y);
        for (let w = 0; w < walls.length && room > enough; ++w) room = Math.min(room, Math.hypot(walls[w][0] - x, walls[w][1] - y));
        return room;
    }

    // Where each region has the most room for its label: the sample of it that is farthest from curves and borders.
    #places() {
        const [left, right, bottom, top] = this.box, walls = this.#walls(), columns = 44, rows = 44;
        const shapes = this.locus.regions.map(region => region.polygons.map(polygon => {
            const points = polygon.map(([x, y]) => [this.sx(x), this.sy(y)]);
            const xs = points.map(p => p[0]), ys = points.map(p => p[1]);
            return {points, box: [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]};
        }));
        const best = this.locus.regions.map(region => ({region, room: 0}));
        const consider = (x, y, k) => {
            const room = this.#room(x, y, walls, best[k].room);
            if (room > best[k].room) Object.assign(best[k], {x, y, room});
        };
        for (let i = 0; i < columns; ++i)
            for (let j = 0; j < rows; ++j) {
                const x = left + (right - left) * (i + 0.5) / columns, y = top + (bottom - top) * (j + 0.5) / rows;
                const k = shapes.findIndex(parts => parts.some(({points, box}) => x >= box[0] && x <= box[1] && y >= box[2] && y <= box[3] && inside(points, x, y)));
                if (k >= 0) consider(x, y, k);
            }
        this.locus.regions.forEach(({point}, k) => consider(this.sx(point[0]), this.sy(point[1]), k));
        return best;
    }

    // The same of what is counted: the farthest cell from the border of its part and from curves.
    #counted_places() {
        const walls = this.#walls(), cells = [...this.raster.cells.values()], {wide, high} = cells[0];
        const [, x0, x1] = this.axes.x, [, y0, y1] = this.axes.y, [left, right, bottom, top] = this.box;
        const unit = Math.min((right - left) * wide / (x1 - x0), (bottom - top) * high / (y1 - y0));
        return counted_regions(cells, x0, y0).map(({count, by_index, cells}) => {
            const best = {region: {count, by_index}, room: 0};
            for (const cell of cells) {
                const x = this.sx(cell.x), y = this.sy(cell.y), inside = unit * (cell.steps - 0.5);
                if (inside <= best.room) continue;
                const room = Math.min(inside, this.#room(x, y, walls, best.room));
                if (room > best.room) Object.assign(best, {x, y, room});
            }
            return best;
        });
    }

    // Counts at the points of a grid, while there are no curves, or where they would take minutes, or bound no regions that are known.
    get counted() {
        return Boolean(this.raster?.cells.size && !(this.locus?.regions.length && !this.stale));
    }
    #draw_raster() {
        const context = this.canvas.getContext('2d'), ratio = devicePixelRatio || 1;
        this.canvas.width = this.size?.[0] * ratio || 1;
        this.canvas.height = this.size?.[1] * ratio || 1;
        const {raster, counted} = this;
        this.svg.classList.toggle('counted', counted);
        if (!counted) return;
        context.scale(ratio, ratio);
        const [left, right, bottom, top] = this.box;
        context.beginPath();
        context.rect(left, top, right - left, bottom - top);
        context.clip();
        const counts = [...new Set([...raster.cells.values()].map(c => c.count))].sort((a, b) => a - b);
        for (const {x, y, count, wide, high} of [...raster.cells.values()].sort((a, b) => b.wide - a.wide)) {
            const [x0, x1] = [this.sx(x - wide / 2), this.sx(x + wide / 2)], [y0, y1] = [this.sy(y + high / 2), this.sy(y - high / 2)];
            context.fillStyle = tint(counts.indexOf(count), counts.length);
            context.fillRect(x0, y0, x1 - x0 + 0.6, y1 - y0 + 0.6);
        }
        if (!raster.finished) return;
        this.layers.labels.replaceChildren();
        this.#label(this.#counted_places());
    }

    #build_point() {
        const {point} = this.layers;
        this.lines = [svg('path', {class: 'cross'}), svg('path', {class: 'cross'})];
        this.handle = svg('g', {
            class: 'handle', tabindex: 0, role: 'slider', 'aria-roledescription': 'movable point', 'aria-label': 'Point in the plane; arrow keys move it',
        }, svg('circle', {r: 22, class: 'touch'}), svg('circle', {r: 10, class: 'halo'}), svg('circle', {r: 7, class: 'dot'}), svg('text', {class: 'cue', x: 15, y: -12}, 'drag me'));
        point.append(...this.lines, this.handle);
    }

    move(at) {
        if (!at || !this.box) return void (this.at = at);
        this.at = at;
        const [left, right, bottom, top] = this.box;
        const x = this.sx(at[0]), y = this.sy(at[1]), visible = x >= left - 1 && x <= right + 1 && y >= top - 1 && y <= bottom + 1;
        this.layers.point.setAttribute('visibility', visible ? 'visible' : 'hidden');
        this.handle.setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
        this.lines[0].setAttribute('d', `M${left} ${y}H${right}`);
        this.lines[1].setAttribute('d', `M${x} ${top}V${bottom}`);
        this.handle.setAttribute('aria-valuenow', at[0]);
        this.say(`${this.axes.x[0]} ${short(at[0])}, ${this.axes.y[0]} ${short(at[1])}`);
    }
    say(words) {
        this.handle.setAttribute('aria-valuetext', words);
    }

    #listen() {
        const pointers = new Map();
        let pinch = null;
        const place = event => {
            const box = this.svg.getBoundingClientRect();
            return [event.clientX - box.left, event.clientY - box.top];
        };
        const go = (event, [px, py]) => {
            this.handle.querySelector('.cue')?.remove();
            const [, x0, x1] = this.axes.x, [, y0, y1] = this.axes.y;
            this.moved([clamp(this.sx.back(px), x0, x1), clamp(this.sy.back(py), y0, y1)], event.timeStamp);
        };
        const spread = () => {
            const [a, b] = [...pointers.values()];
            return {distance: Math.hypot(a[0] - b[0], a[1] - b[1]), centre: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]};
        };
        this.svg.addEventListener('pointerdown', event => {
            if (!this.axes || event.button) return;
            const at = place(event);
            pointers.set(event.pointerId, at);
            this.svg.setPointerCapture(event.pointerId);
            if (pointers.size === 2) pinch = spread();
            else go(event, at);
            this.svg.classList.remove('keys');
            this.handle.focus({preventScroll: true});
            this.svg.classList.add('dragging');
            event.preventDefault();
        });
        this.svg.addEventListener('pointermove', event => {
            if (!pointers.has(event.pointerId)) return;
            const at = place(event);
            pointers.set(event.pointerId, at);
            if (pointers.size >= 2) {
                const now = spread();
                if (Math.abs(now.distance - pinch.distance) > 6) {
                    this.zoom(pinch.distance / now.distance, now.centre);
                    pinch = now;
                }
            } else {
                go(event, at);
            }
        });
        const end = event => {
            pointers.delete(event.pointerId);
            if (!pointers.size) this.svg.classList.remove('dragging');
        };
        this.svg.addEventListener('pointerup', end);
        this.svg.addEventListener('pointercancel', end);
        this.svg.addEventListener('wheel', event => {
            event.preventDefault();
            this.zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.0015), place(event));
        }, {passive: false});
        this.handle.addEventListener('keyup', () => this.svg.classList.add('keys'));
        this.handle.addEventListener('keydown', event => {
            const direction = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
            if (direction) {
                this.handle.querySelector('.cue')?.remove();
                const [, x0, x1] = this.axes.x, [, y0, y1] = this.axes.y, step = event.shiftKey ? 0.05 : event.altKey ? 0.0005 : 0.005;
                this.moved([
                    clamp(this.at[0] + direction[0] * step * (x1 - x0), x0, x1), clamp(this.at[1] + direction[1] * step * (y1 - y0), y0, y1),
                ], event.timeStamp);
            } else if (event.key === '+' || event.key === '=') {
                this.zoom(0.6);
            } else if (event.key === '-') {
                this.zoom(1 / 0.6);
            } else {
                return;
            }
            event.preventDefault();
        });
    }

    // The window `factor` times as wide, the place that stays where it is: in pixels, else the point.
    zoom(factor, centre = [this.sx(this.at[0]), this.sy(this.at[1])]) {
        const [nx, x0, x1] = this.axes.x, [ny, y0, y1] = this.axes.y;
        const cx = this.sx.back(centre[0]), cy = this.sy.back(centre[1]);
        this.viewed([nx, cx - (cx - x0) * factor, cx + (x1 - cx) * factor], [ny, cy - (cy - y0) * factor, cy + (y1 - cy) * factor]);
    }
}

function inside(points, x, y) {
    let odd = false;
    for (let i = 0, j = points.length - 1; i < points.length; j = i++) {
        const [xi, yi] = points[i], [xj, yj] = points[j];
        if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) odd = !odd;
    }
    return odd;
}
