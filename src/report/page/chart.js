// Charts: a frame with its controls, axes, labels that do not touch, and the chart's way out of the
// page as SVG and as CSV.

/// A chart in `parent`: {id, title, isNamed, note, height, least, controls: [elements], draw(chart), csv()}.
/// Where the part above says what it is, no title is shown (`isNamed`).
/// `draw` is given {svg, width, height} and is called again when the width changes. `csv` gives
/// lines of fields, the heading first.
function makeChart(parent, {id, title, isNamed = true, note, height = 420, least = 320, controls = [], draw, csv}) {
    const body = element('div', {class: 'chart-body scroll', tabindex: '0', role: 'group', 'aria-label': title});
    const figure = element('figure', {class: 'chart', id: `chart-${id}`},
        element('div', {class: 'chart-head'}, isNamed ? element('h3', {}, title) : null,
            element('div', {class: 'tools'}, controls,
                element('button', {type: 'button', class: 'quiet', onclick: () => saveFile(
                    `${id}.svg`, 'image/svg+xml', svgText(body.querySelector('svg')))}, 'SVG'),
                csv ? element('button', {type: 'button', class: 'quiet', onclick: () => saveFile(
                    `${id}.csv`, 'text/csv', csvText(csv()))}, 'CSV') : null)),
        note ? element('p', {class: 'note'}, note) : null,
        body);
    parent.append(figure);
    let drawnWidth = 0;
    const redraw = room_px => {
        const width = Math.max(least, Math.round(room_px));
        if (width === drawnWidth) return;
        drawnWidth = width;
        const tall = typeof height === 'function' ? height(width) : height;
        body.replaceChildren();
        const svg = d3.select(body).append('svg').attr('viewBox', `0 0 ${width} ${tall}`)
            .attr('width', width).attr('height', tall).attr('role', 'group').attr('aria-label', title);
        draw({svg, width, height: tall});
    };
    redraw(body.clientWidth || parent.clientWidth || 900);
    watchWidth(body, redraw);
    return figure;
}

/// A drawing as a file of its own: in the light theme, with every style written out.
function svgText(svg) {
    const stage = element('div', {class: 'light-theme', style: 'position:absolute;left:-9999px'});
    const copy = svg.cloneNode(true);
    stage.append(copy);
    document.body.append(stage);
    const kept = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linejoin',
                  'paint-order', 'opacity', 'fill-opacity', 'font-size', 'font-family', 'font-weight',
                  'text-anchor'];
    for (const node of [copy, ...copy.querySelectorAll('*')]) {
        const style = getComputedStyle(node);
        for (const name of kept) {
            const value = style.getPropertyValue(name);
            if (value && value !== 'none' && value !== 'normal') node.setAttribute(name, value);
            else if (name === 'fill' && value === 'none') node.setAttribute(name, value);
        }
        node.removeAttribute('style');
        node.removeAttribute('class');
    }
    copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
    stage.remove();
    return `<?xml version="1.0" encoding="UTF-8"?>\n${copy.outerHTML}\n`;
}

/// Where a chart is drawn inside its margins.
function plotArea({svg, width, height}, margin) {
    return {
        plot: svg.append('g').attr('transform', `translate(${margin.left},${margin.top})`),
        width: width - margin.left - margin.right,
        height: height - margin.top - margin.bottom,
    };
}

/// Ticks of a logarithmic axis at 1, 2 and 5 times powers of ten, as many as fit.
function logTicks(scale, room_px) {
    const [low, high] = scale.domain();
    const all = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
        for (const factor of [1, 2, 5]) all.push(factor * 10 ** power);
    const inside = all.filter(tick => tick >= low * 0.999 && tick <= high * 1.001);
    if (inside.length * 46 <= room_px) return inside;
    const tens = inside.filter(tick => Number.isInteger(Math.round(Math.log10(tick) * 1e6) / 1e6));
    return tens.length > 1 ? tens : inside.filter((_, index) => index % 2 === 0);
}

/// An axis with its grid and its title. `side` is 'bottom' or 'left'; `across` is how far the grid
/// goes.
function drawAxis(plot, scale, {side, title, isLog = false, format = formatNumber, length, across, ticks}) {
    const values = ticks || (isLog ? logTicks(scale, side === 'bottom' ? length : length * 1.6)
                                   : scale.ticks(Math.max(3, Math.round(length / (side === 'bottom' ? 90 : 50)))));
    const axis = plot.append('g').attr('class', 'axis');
    for (const value of values) {
        const at = scale(value);
        const line = axis.append('line').attr('class', 'grid');
        const text = axis.append('text').attr('class', 'tick').text(format(value));
        if (side === 'bottom') {
            line.attr('x1', at).attr('x2', at).attr('y1', 0).attr('y2', across);
            text.attr('x', at).attr('y', across + 17).attr('text-anchor', 'middle');
        } else {
            line.attr('x1', 0).attr('x2', across).attr('y1', at).attr('y2', at);
            text.attr('x', -8).attr('y', at + 4).attr('text-anchor', 'end');
        }
    }
    const name = axis.append('text').attr('class', 'axis-title').text(title);
    if (side === 'bottom') name.attr('x', length / 2).attr('y', across + 38).attr('text-anchor', 'middle');
    else name.attr('x', -8).attr('y', -12).attr('text-anchor', 'start');
    return axis;
}

/// A linear or logarithmic scale over values with some air; logarithmic ones need values above 0.
function makeScale(values, range, {isLog = false, includesZero = false, least = null} = {}) {
    const shown = values.filter(value => isNumber(value) && (!isLog || value > 0));
    let [low, high] = shown.length ? d3.extent(shown) : [isLog ? 0.1 : 0, 1];
    if (least !== null) low = Math.max(low, least);
    if (isLog) {
        if (low === high) [low, high] = [low / 2, high * 2];
        const air = (high / low) ** 0.05;
        return d3.scaleLog().domain([low / air, high * air]).range(range);
    }
    if (includesZero) low = Math.min(0, low);
    if (low === high) [low, high] = [low - 0.5, high + 0.5];
    const air = 0.05 * (high - low);
    return d3.scaleLinear().domain([includesZero && low === 0 ? 0 : low - air, high + air]).range(range);
}

/// Writes texts beside points so that none touches another, a point, or the frame: each takes the
/// first place round its point that is free, with a thin line to it where that is far; one without a
/// place is left out. `points` are {x, y, text, colour, isFirst}, in px: those that are first choose
/// first. `bars` are [x1, y1, x2, y2], through which no text is written either.
function placeLabels(plot, points, width, height, bars = []) {
    const taken = [...points.map(p => ({x0: p.x - 6, y0: p.y - 6, x1: p.x + 6, y1: p.y + 6})),
                   ...bars.map(([x1, y1, x2, y2]) => ({x0: Math.min(x1, x2) - 1, y0: Math.min(y1, y2) - 1,
                                                       x1: Math.max(x1, x2) + 1, y1: Math.max(y1, y2) + 1}))];
    const layer = plot.append('g').attr('class', 'labels');
    const high = 13;
    const places = [];
    for (const far of [8, 16, 28, 42, 58, 76, 96].filter(one => one < Math.max(20, width / 8))) {
        for (const [dx, dy] of [[1, 0], [-1, 0], [0, -1], [0, 1], [0.75, -0.75], [0.75, 0.75], [-0.75, -0.75], [-0.75, 0.75]])
            places.push([dx * far, dy * far, far]);
    }
    const touches = (a, b) => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
    for (const point of [...points].sort((a, b) => Boolean(b.isFirst) - Boolean(a.isFirst) || a.x - b.x || a.y - b.y)) {
        const long = point.text.length * 6.6 + 2;
        const boxAt = ([dx, dy]) => {
            const x0 = dx > 0 ? point.x + dx : dx < 0 ? point.x + dx - long : point.x - long / 2;
            const y0 = point.y + dy - high / 2;
            return {x0, y0, x1: x0 + long, y1: y0 + high};
        };
        const isInside = box => box.x0 >= 0 && box.x1 <= width && box.y0 >= 0 && box.y1 <= height;
        const place = places.find(p => {
            const box = boxAt(p);
            return isInside(box) && !taken.some(other => touches(box, other));
        });
        if (!place) continue;
        const box = boxAt(place);
        taken.push(box);
        if (place[2] > 16) {
            layer.append('line').attr('class', 'leader').attr('x1', point.x).attr('y1', point.y)
                .attr('x2', Math.min(Math.max(point.x, box.x0), box.x1)).attr('y2', (box.y0 + box.y1) / 2);
        }
        layer.append('text').attr('class', 'label').attr('x', box.x0).attr('y', box.y1 - 3)
            .style('fill', point.colour).text(point.text);
    }
}

/// Texts at the right ends of lines, moved apart where they would touch. `ends` are {y, text, colour}.
function placeEndLabels(plot, ends, x, height) {
    const gap = 14;
    const placed = ends.filter(end => isNumber(end.y)).sort((a, b) => a.y - b.y).map(end => ({...end, at: end.y}));
    for (let i = 1; i < placed.length; ++i) placed[i].at = Math.max(placed[i].at, placed[i - 1].at + gap);
    if (placed.length && placed[placed.length - 1].at > height) {
        placed[placed.length - 1].at = height;
        for (let i = placed.length - 2; i >= 0; --i) placed[i].at = Math.min(placed[i].at, placed[i + 1].at - gap);
    }
    for (const end of placed) {
        plot.append('line').attr('class', 'leader').attr('x1', x).attr('y1', end.y).attr('x2', x + 10).attr('y2', end.at);
        plot.append('text').attr('class', 'label').attr('x', x + 13).attr('y', end.at + 4).style('fill', end.colour).text(end.text);
    }
}

/// A colour scale for errors: that of the paper at 0, red at `worst`.
function errorColour(share, worst) {
    const part = Math.min(1, Math.max(0, share / worst)) ** 0.6;
    return `color-mix(in srgb, var(--bad) ${(60 * part).toFixed(0)}%, var(--paper))`;
}

/// The same as a cell's background; hatched where there is no score.
function errorShade(share, worst) {
    return `background: ${isNumber(share) ? errorColour(share, worst) : 'var(--hatch)'}`;
}
