// What watches an element from outside, an observer, a timer or a floating box, ends when the element
// leaves the page. Whatever else outlives the element would go on drawing what nobody sees.

/// Per watched element, what ends with it.
const endings = new Map();

const departures = new MutationObserver(() => {
    for (const [node, ends] of endings) {
        if (node.isConnected) continue;
        endings.delete(node);
        for (const end of ends) end();
    }
});
departures.observe(document, {childList: true, subtree: true});

/// Calls `end` once when `node` has left the page. A new node may be put there until the script that
/// made it is done.
function whenGone(node, end) {
    if (!endings.has(node)) endings.set(node, new Set());
    endings.get(node).add(end);
}

/// Calls `onWidth` with the width of `node` in px now and after each change, as long as it stands on
/// the page. Where it has no width, as in a folded part, there is nothing to draw on and no call.
function watchWidth(node, onWidth) {
    const look = () => {
        if (node.clientWidth > 0) onWidth(node.clientWidth);
    };
    look();
    const observer = new ResizeObserver(look);
    observer.observe(node);
    whenGone(node, () => observer.disconnect());
}

/// A watcher that calls `onSeen` once with each node it observes, when that comes near the window;
/// it ends with `owner`.
function watchSeen(owner, margin_px, onSeen) {
    const observer = new IntersectionObserver(entries => {
        for (const {target} of entries.filter(entry => entry.isIntersecting)) {
            observer.unobserve(target);
            onSeen(target);
        }
    }, {rootMargin: `${margin_px}px`});
    whenGone(owner, () => observer.disconnect());
    return observer;
}

/// Calls `onTick` every `time_ms` as long as `node` stands on the page; the function it returns
/// stops it before.
function tickWhileThere(node, time_ms, onTick) {
    const timer = setInterval(onTick, time_ms);
    const stop = () => clearInterval(timer);
    whenGone(node, stop);
    return stop;
}
