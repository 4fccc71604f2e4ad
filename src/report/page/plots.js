// What several charts draw: lines of methods, bars, and the small box of text beside the pointer.

const tip = {node: null, target: null};

/// Shows `text`, a line or several, beside the pointer, at most as long as `target` stands there.
function showTip(text, x, y, target) {
    if (!tip.node) {
        tip.node = element('div', {class: 'tip', role: 'tooltip'});
        document.body.append(tip.node);
    }
    tip.node.replaceChildren(...[text].flat().map(line => element('div', {}, line)));
    tip.node.hidden = false;
    tip.target = target;
    whenGone(target, hideLostTip);
    const {offsetWidth: width, offsetHeight: height} = tip.node;
    const left = x + 14 + width > innerWidth ? x - 14 - width : x + 14;
    tip.node.style.left = `${Math.max(4, left)}px`;
    tip.node.style.top = `${Math.max(4, Math.min(y + 14, innerHeight - height - 4))}px`;
}

function hideTip() {
    if (tip.node) tip.node.hidden = true;
}

/// What was drawn anew under the pointer never says that the pointer left.
function hideLostTip() {
    if (!tip.target.isConnected) hideTip();
}

/// Lets a node answer the pointer, a finger and the keyboard with a text.
function answerText(node, text) {
    const target = node.node ? node.node() : node;
    const show = event => showTip(text, event.clientX, event.clientY, target);
    target.setAttribute('tabindex', '0');
    target.setAttribute('role', 'img');
    target.setAttribute('aria-label', [text].flat().join(', '));
    target.addEventListener('pointerenter', show);
    target.addEventListener('pointermove', show);
    target.addEventListener('pointerleave', hideTip);
    target.addEventListener('focus', () => {
        const box = target.getBoundingClientRect();
        showTip(text, box.right, box.top, target);
    });
    target.addEventListener('blur', hideTip);
}

/// The room, in px, that methods' names take beside a plot.
function plotLabelWidth(lines) {
    return 24 + 6.8 * d3.max([4, ...lines.map(line => line.name.length)]);
}

/// The path of a line through points; null among them interrupts it.
function pathThrough(points, x, y) {
    return d3.line().x(x).y(y).defined(Boolean)(points);
}

/// A method's line: {name, info, colour, isDashed, points}. A point is {x, y, low, high, text, rows};
/// `low` and `high` are an interval in y, `text` what the pointer reads there, `rows` whose images a
/// click shows.
function methodLine(info, points) {
    return {
        name: info.name, info, points, colour: colourOf(info), isDashed: Boolean(info.presetOf) || info.isBaseline,
    };
}

/// A number on an axis: no more digits than it needs.
function formatTick(value) {
    const size = Math.abs(value);
    return size >= 1e5 || (value !== 0 && size < 1e-3) ? formatNumber(value) : String(Number(value.toPrecision(4)));
}

/// Both axes of a plot; `bottom` and `left` are what drawAxis() is asked for, or null for none.
function drawAxes({plot, width, height}, x, y, {bottom, left}) {
    if (left) drawAxis(plot, y, {side: 'left', length: height, across: width, format: formatTick, ...left});
    if (bottom) drawAxis(plot, x, {side: 'bottom', length: width, across: height, format: formatTick, ...bottom});
}

/// A chart of lines with its axes. `x` and `y` make a scale for a range in px; `under` and `over` draw
/// below and above the lines; names stand at the ends of lines where there is room.
function plotLines(chart, {lines, x, y, bottom, left, room_px = 52, foot_px = 46, labels = true, under, over,
    ...looks}) {
    const isWide = labels && chart.width >= 620;
    const area = plotArea(chart, {top: 26, right: isWide ? plotLabelWidth(lines) : 16, bottom: foot_px, left: room_px});
    const [xs, ys] = [x([0, area.width]), y([area.height, 0])];
    drawAxes(area, xs, ys, {bottom, left});
    if (under) under(area, xs, ys);
    drawLines(area.plot, {lines, x: xs, y: ys, width: area.width, height: area.height, labels: isWide, ...looks});
    if (over) over(area, xs, ys);
}

/// How tall a chart must be so that the names at its lines' ends have room.
function linesHeight(least_px, lines) {
    return width => Math.max(least_px, width >= 620 ? 90 + 14 * lines.length : 0);
}

/// Draws lines on a plot: {lines, x, y, width, height, markers, intervals, labels}. The pointer
/// picks the nearest point, says what it is and dims the other lines.
function drawLines(plot, {lines, x, y, width, height, markers = true, intervals = false, labels = false}) {
    const isDrawn = point => isNumber(point.y) && isNumber(x(point.x)) && isNumber(y(point.y));
    const least = d3.min(y.domain()); // of a logarithmic scale: 0 has no place on it
    const layer = plot.append('g').attr('class', 'method-lines');
    const spots = [];
    for (const line of lines) {
        const points = line.points.filter(isDrawn);
        const group = layer.append('g').attr('data-method', line.name);
        group.append('path').attr('d', pathThrough(points, p => x(p.x), p => y(p.y))).style('fill', 'none')
            .style('stroke', line.colour).style('stroke-width', 1.7).style('stroke-linejoin', 'round')
            .style('stroke-dasharray', line.isDashed ? '6 3' : null);
        for (const point of points) {
            if (intervals && isNumber(point.low) && isNumber(point.high)) {
                group.append('line').attr('x1', x(point.x)).attr('x2', x(point.x))
                    .attr('y1', y(Math.max(point.low, least))).attr('y2', y(Math.max(point.high, least)))
                    .style('stroke', line.colour).style('stroke-width', 1).style('opacity', 0.45);
            }
            if (markers) {
                group.append('path').attr('d', line.info ? markerOf(line.info) : MARKERS.circle)
                    .attr('transform', `translate(${x(point.x)},${y(point.y)}) scale(0.65)`)
                    .call(lineMarkerStyle, line);
            }
            spots.push({px: x(point.x), py: y(point.y), line, point});
        }
    }
    if (labels) {
        const ends = lines.map(line => ({line, last: line.points.filter(isDrawn).pop()})).filter(end => end.last);
        placeEndLabels(plot, ends.map(({line, last}) => ({y: y(last.y), text: line.name, colour: line.colour})),
                       width, height);
    }
    answerNearest(plot, layer, spots, width, height);
}

function lineMarkerStyle(path, line) {
    path.style('fill', line.info && line.info.presetOf ? 'var(--paper)' : line.colour)
        .style('stroke', line.colour).style('stroke-width', 1.6);
}

/// A sheet over the plot that answers with the point nearest to the pointer.
function answerNearest(plot, layer, spots, width, height) {
    const sheet = plot.append('rect').attr('class', 'sheet').attr('x', -6).attr('y', -6)
        .attr('width', width + 12).attr('height', height + 12).style('fill', 'transparent');
    const ring = plot.append('circle').attr('r', 7).style('fill', 'none').style('stroke', 'var(--ink)')
        .style('stroke-width', 1.5).style('pointer-events', 'none').attr('visibility', 'hidden');
    const nearest = event => {
        const box = sheet.node().getBoundingClientRect();
        const [px, py] = [event.clientX - box.left - 6, event.clientY - box.top - 6];
        const far = spot => (spot.px - px) ** 2 + (spot.py - py) ** 2;
        let best = null;
        for (const spot of spots) if (!best || far(spot) < far(best)) best = spot;
        return best && far(best) < 3600 ? best : null;
    };
    const leave = () => {
        ring.attr('visibility', 'hidden');
        dimOthers(layer.node(), null);
        hideTip();
    };
    const look = event => {
        const spot = nearest(event);
        if (!spot) return leave();
        ring.attr('visibility', 'visible').attr('cx', spot.px).attr('cy', spot.py);
        dimOthers(layer.node(), spot.line.name);
        showTip(spot.point.text, event.clientX, event.clientY, sheet.node());
        sheet.style('cursor', hasImages(spot.point.rows) ? 'pointer' : null);
    };
    sheet.on('pointermove', () => look(d3.event)).on('pointerdown', () => look(d3.event))
        .on('pointerleave', leave)
        .on('click', () => {
            const spot = nearest(d3.event);
            if (!spot || !hasImages(spot.point.rows)) return;
            d3.event.stopPropagation();
            hideTip();
            showCard(sheet.node(), spot.point.rows, [spot.point.text].flat(), d3.event);
            pinCard();
        });
}

function hasImages(rows) {
    return Boolean(rows && rows.some(row => viewImages.has(runOf(row), row.scene, row.view, row.method)));
}

/// Fades all lines below `root` but those of one method; null fades none.
function dimOthers(root, name) {
    for (const group of root.querySelectorAll('[data-method]'))
        group.style.opacity = name === null || group.dataset.method === name ? 1 : 0.15;
}

/// The methods of a part's charts with their markers; the pointer on one picks it out in all of them.
function methodLegend(root, infos) {
    return element('ul', {class: 'legend'}, infos.map(info => element('li', {
        onpointerenter: () => dimOthers(root, info.name),
        onpointerleave: () => dimOthers(root, null),
    }, methodName(info))));
}

/// Horizontal bars, one per method: {bars: [{info, pieces: [{value, colour, isPale, text}]}], title,
/// format, most}. `pieces` lie end to end; a bar without any shows a dash.
function drawStackedBars(chart, {bars, title, format = formatNumber, most = null}) {
    const left = Math.min(plotLabelWidth(bars.map(bar => bar.info)) + 4, 0.4 * chart.width);
    const area = plotArea(chart, {top: 8, right: 58, bottom: 46, left});
    const total = bar => d3.sum(bar.pieces, piece => piece.value);
    const end = most || d3.max(bars, total) || 1;
    const x = d3.scaleLinear().domain([0, end]).range([0, area.width]);
    const y = d3.scaleBand().domain(bars.map(bar => bar.info.name)).range([0, area.height]).padding(0.3);
    drawAxis(area.plot, x, {side: 'bottom', title, format, length: area.width, across: area.height});
    for (const bar of bars) {
        const group = area.plot.append('g').attr('data-method', bar.info.name);
        const middle = y(bar.info.name) + y.bandwidth() / 2;
        group.append('text').attr('class', 'tick').attr('x', -8).attr('y', middle + 4)
            .attr('text-anchor', 'end').text(bar.info.name);
        let from = 0;
        for (const piece of bar.pieces.filter(p => p.value > 0)) {
            const rect = group.append('rect').attr('x', x(from)).attr('y', y(bar.info.name))
                .attr('width', Math.max(0.5, x(from + piece.value) - x(from)))
                .attr('height', y.bandwidth()).style('fill', piece.colour).style('fill-opacity', piece.isPale
                    ? 0.45 : 1);
            answerText(rect, piece.text);
            from += piece.value;
        }
        group.append('text').attr('class', 'tick').attr('x', x(from) + 6).attr('y', middle + 4)
            .text(bar.pieces.length ? format(total(bar)) : NOTHING);
    }
}

/// Methods' names left of a plot, one a band from top to bottom, in the colours of their families.
function drawNames(plot, infos, band_px) {
    infos.forEach((info, i) => {
        plot.append('text').attr('class', 'tick').attr('x', -10).attr('y', (i + 0.5) * band_px + 4)
            .attr('text-anchor', 'end').style('fill', colourOf(info)).text(info.name);
    });
}

/// How tall a chart of bars is for so many methods.
function barsHeight(bars) {
    return 54 + 25 * Math.max(1, bars.length);
}

/// Room for charts side by side, as many as fit.
function chartGrid(...charts) {
    return element('div', {class: 'chart-grid'}, charts);
}

/// Colours as a legend: [colour, text, isPale] each.
function colourLegend(entries) {
    const shade = (colour, isPale) => (isPale ? `color-mix(in srgb, ${colour} 45%, var(--paper))` : colour);
    return element('ul', {class: 'legend'}, entries.map(([colour, text, isPale]) => element('li', {},
        element('i', {style: `background:${shade(colour, isPale)}`}), text)));
}
