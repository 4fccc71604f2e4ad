"""Counts what a reader sees: the drawn pixels of the page's canvases and charts, in a screenshot.

A canvas is a picture on white. Of the viewer's stage both sides of the divider count, each for itself.
A chart counts what differs from its background: `ink` is all of it, `colour` what is no grey.
"""

# What is on its way is awaited: frames in which observers fire, then the images that they asked for,
# then a frame that shows them.
SETTLED = """
const done = arguments[arguments.length - 1];
const frames = number => new Promise(resolve => {
    const next = left => (left ? requestAnimationFrame(() => next(left - 1)) : resolve());
    next(number);
});
(async () => {
    await frames(2);
    await Promise.all(viewImages.decoded.values());
    await frames(2);
})().then(done);
"""

# Canvases and charts below arguments[0] that have room on the page, in its coordinates, cut to the
# part that no box of their own scrolls away. Thumbnails are drawn when they come into the window:
# those that wholly stand in it count.
FIND = """
const seen = node => {
    let {left, top, right, bottom} = node.getBoundingClientRect();
    for (let box = node.parentElement; box; box = box.parentElement) {
        if (getComputedStyle(box).overflow === 'visible' || box === document.body) continue;
        const edge = box.getBoundingClientRect();
        left = Math.max(left, edge.left); right = Math.min(right, edge.right);
        top = Math.max(top, edge.top); bottom = Math.min(bottom, edge.bottom);
    }
    return {x: left + scrollX, y: top + scrollY, width: right - left, height: bottom - top};
};
const isInWindow = node => {
    const [box, own] = [seen(node), node.getBoundingClientRect()];
    return box.width > own.width - 1 && box.height > own.height - 1 && own.top >= 0 && own.bottom <= innerHeight;
};
const named = (node, kind, name) => ({kind, name, ...seen(node), cut: kind === 'stage' ? Number(node.dataset.cut) : null});
return [...document.querySelectorAll(`${arguments[0]} :is(canvas, .chart-body > svg)`)]
    .filter(node => node.checkVisibility() && (!node.matches('.thumb') || isInWindow(node))).map(node =>
    node.matches('.stage') ? named(node, 'stage', 'the viewer')
    : node.matches('.thumb') ? named(node, 'thumb', node.dataset.what.split('\\n').join(' '))
    : node.matches('canvas') ? named(node, 'card', 'the card')
    : named(node, 'chart', node.closest('figure').id)).filter(box => box.width > 8 && box.height > 8);
"""

COUNT = """
const [png, boxes, left, top, done] = arguments;
const image = new Image();
image.src = `data:image/png;base64,${png}`;
image.decode().then(() => {
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d', {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    const count = (x, y, width, height, isHit) => {
        const pixels = context.getImageData(Math.round(x - left), Math.round(y - top), Math.max(1, Math.floor(width)),
                                            Math.max(1, Math.floor(height))).data;
        let hits = 0;
        for (let i = 0; i < pixels.length; i += 4) if (isHit(pixels[i], pixels[i + 1], pixels[i + 2])) ++hits;
        return hits;
    };
    const isDark = (r, g, b) => Math.min(r, g, b) < 150;
    const isColour = (r, g, b) => Math.max(r, g, b) - Math.min(r, g, b) > 60;
    done(boxes.map(({kind, x, y, width, height, cut}) => {
        if (kind === 'chart') {
            const [r0, g0, b0] = context.getImageData(Math.round(x - left), Math.round(y - top), 1, 1).data;
            return {ink: count(x, y, width, height, (r, g, b) => Math.abs(r - r0) + Math.abs(g - g0) + Math.abs(b - b0) > 90),
                    colour: count(x, y, width, height, isColour)};
        }
        // Inside the border; the divider itself is no picture.
        [x, y, width, height] = [x + 3, y + 3, width - 6, height - 6];
        if (kind !== 'stage') return {ink: count(x, y, width, height, isDark)};
        return {left: count(x, y, cut * width - 4, height, isDark),
                right: count(x + cut * width + 4, y, (1 - cut) * width - 4, height, isDark)};
    }));
});
"""

# Attributes that a drawing leaves where a number was missing.
BROKEN = """
return [...document.querySelectorAll('body *')].flatMap(node => [...node.attributes]
    .filter(({name, value}) => !['title', 'aria-label', 'value'].includes(name) && /NaN|undefined|Infinity/.test(value))
    .map(({name, value}) => `${node.closest('[id]')?.id}: ${node.tagName} ${name}="${value.slice(0, 60)}"`)).slice(0, 5);
"""


def settle(browser):
    browser.execute_async_script(SETTLED)


def broken_attributes(browser):
    return browser.execute_script(BROKEN)


def count_ink(browser, root="body"):
    """Drawn pixels of all visible canvases and charts below `root`: [{kind, name, width, height, ...}]."""
    settle(browser)
    boxes = browser.execute_script(FIND, root)
    if not boxes:
        return []
    left, top = min(b["x"] for b in boxes), min(b["y"] for b in boxes)
    clip = {"x": left, "y": top, "scale": 1,
            "width": max(b["x"] + b["width"] for b in boxes) - left,
            "height": max(b["y"] + b["height"] for b in boxes) - top}
    png = browser.execute_cdp_cmd("Page.captureScreenshot", {
        "format": "png", "clip": clip, "captureBeyondViewport": True, "optimizeForSpeed": True})["data"]
    counts = browser.execute_async_script(COUNT, png, boxes, left, top)
    return [{**box, **found} for box, found in zip(boxes, counts)]
