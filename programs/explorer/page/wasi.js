// What the engine imports of WASI, as small as it may be: a clock, random bytes, output to the console; no files, no environment.
const bad_descriptor = 8;

export function wasi(memory) {
    const view = () => new DataView(memory().buffer);
    const known = {
        clock_time_get(clock, precision, time) {
            view().setBigUint64(time, BigInt(Math.round((performance.timeOrigin + performance.now()) * 1e3)) * 1000n, true);
            return 0;
        },
        clock_res_get(clock, resolution) {
            view().setBigUint64(resolution, 1000n, true);
            return 0;
        },
        random_get(bytes, length) {
            for (let done = 0; done < length; done += 65536)
                crypto.getRandomValues(new Uint8Array(memory().buffer, bytes + done, Math.min(65536, length - done)));
            return 0;
        },
        environ_sizes_get(count, size) {
            view().setUint32(count, 0, true);
            view().setUint32(size, 0, true);
            return 0;
        },
        environ_get: () => 0,
        args_sizes_get(count, size) {
            return known.environ_sizes_get(count, size);
        },
        args_get: () => 0,
        sched_yield: () => 0,
        fd_write(descriptor, parts, count, written) {
            let text = '', total = 0;
            for (let part = 0; part < count; ++part) {
                const from = view().getUint32(parts + 8 * part, true), length = view().getUint32(parts + 8 * part + 4, true);
                text += new TextDecoder().decode(new Uint8Array(memory().buffer, from, length));
                total += length;
            }
            if (text.trim()) console.info(text.trimEnd());
            view().setUint32(written, total, true);
            return 0;
        },
        proc_exit(status) {
            throw new Error(`the engine ended with status ${status}`);
        },
    };
    return new Proxy(known, {get: (functions, name) => functions[name] ?? (() => bad_descriptor), has: () => true});
}

// A module's imports: only functions of WASI.
export function imports_of(module, memory) {
    const all = wasi(memory), found = {};
    for (const wanted of WebAssembly.Module.imports(module)) (found[wanted.module] ??= {})[wanted.name] = all[wanted.name];
    return found;
}
