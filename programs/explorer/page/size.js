// The size of an element, for drawing in it: told by an observer, as asking for it in each picture lays out the whole page again.
export function watched_size(element, changed) {
    let size = null;
    new ResizeObserver(([{contentRect: {width, height}}]) => {
        size = {width, height};
        changed();
    }).observe(element);
    return () => (size?.width ? size : (size = element.getBoundingClientRect()));
}
