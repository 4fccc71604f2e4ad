// Tuning: what a search for better settings tried, and what it found.

const TUNING_PHASES = [
    ['start', 'var(--ink)', 'the setting it starts from'],
    ['global', 'var(--family-packed)', 'global search'],
    ['local', 'var(--family-ids)', 'local search'],
    ['random', 'var(--class-intersection)', 'random search, for comparison'],
];

addSection({
    id: 'tuning',
    title: 'Tuning',
    intro: 'A seeded search lowers the error over the training views. Random settings, as many, show what luck ' +
        'alone would find.',
    isThere: view => view.run.has('evaluations.csv'),
    uses: ['sort.evaluations'],
    draw(root, view) {
        const table = view.run.table('evaluations.csv');
        const fixed = ['evaluation', 'phase', 'e_train', 'drawn_by', 'draw_ms'];
        const params = table.names.filter(name => !fixed.includes(name) && distinct(table.column(name),
            value => value).length > 1);
        const lines = table.lines.filter(line => isNumber(line.e_train));
        root.append(element('p', {}, tuningSentence(lines)),
            colourLegend(TUNING_PHASES.filter(([phase]) => lines.some(l => l.phase === phase))
                .map(([, colour, text]) => [colour, text])));
        tuningProgress(root, lines);
        root.append(element('h3', {}, 'Error against each parameter'));
        const grid = chartGrid();
        root.append(grid);
        const range = tuningRange(lines);
        for (const param of params) tuningParam(grid, param, lines, range);
        tuningLandscapes(root, params, lines);
        tuningTable(root, table, lines);
    },
});

function tuningColour(phase) {
    return (TUNING_PHASES.find(([name]) => name === phase) || [null, 'var(--soft)'])[1];
}

/// Searches in the order of their evaluations: the random one counts anew.
function tuningSearches(lines) {
    return [{name: 'search', colour: 'var(--family-packed)', lines: lines.filter(line => line.phase !== 'random')},
            {name: 'random', colour: tuningColour('random'),
                lines: lines.filter(line => line.phase === 'random')}].filter(s => s.lines.length);
}

function tuningBest(lines) {
    return lines.length ? lines.reduce((a, b) => (b.e_train < a.e_train ? b : a)) : null;
}

function tuningSentence(lines) {
    const start = lines.find(line => line.phase === 'start');
    const [search, random] = [lines.filter(line => line.phase !== 'random'),
        lines.filter(line => line.phase === 'random')].map(tuningBest);
    if (!search) return 'No evaluation came out.';
    return `Best error ${formatShare(search.e_train, 4)} over the training views, found by evaluation ` +
        `${search.evaluation} (${search.phase})` +
        (start ? `; it began at ${formatShare(start.e_train, 4)}` : '') +
            (random ? `. The best random setting has ${formatShare(random.e_train, 4)}` : '') + '.';
}

function tuningText(line) {
    return [`evaluation ${line.evaluation}, ${line.phase}`, `error ${formatShare(line.e_train, 4)}` +
        (isNumber(line.draw_ms) ? `, ${formatMs(line.draw_ms)} ms` : '')];
}

function tuningRange(lines) {
    const errors = ascending(lines.map(line => line.e_train));
    const [low, high] = [errors[0], quantile(errors, 0.9)];
    return [Math.max(0, low - 0.06 * (high - low || 0.01)), high + 0.06 * (high - low || 0.01)];
}

/// Every evaluation as a dot, the best so far as a line.
function tuningProgress(root, lines) {
    const range = tuningRange(lines);
    const outside = lines.filter(line => line.e_train > range[1]).length;
    makeChart(root, {
        id: 'tuning', title: 'Best error so far', height: 340,
        note: 'Dots: single evaluations. Lines: the best so far.' + (outside
            ? ` On the upper edge: ${count(outside, 'evaluation')} with a larger error.` : ''),
        draw: chart => {
            const isWide = chart.width >= 620;
            const area = plotArea(chart, {top: 26, right: isWide ? 70 : 14, bottom: 46, left: 56});
            const x = d3.scaleLinear().domain([0, d3.max(lines, line => line.evaluation) + 1]).range([0, area.width]);
            const y = d3.scaleLinear().domain(range).range([area.height, 0]).clamp(true);
            drawAxes(area, x, y, {bottom: {title: 'evaluations'}, left: {title: 'error over the training views'}});
            for (const line of lines) {
                area.plot.append('circle').attr('cx', x(line.evaluation)).attr('cy', y(line.e_train)).attr('r', 2.6)
                    .style('fill', tuningColour(line.phase)).style('opacity', 0.45);
            }
            drawLines(area.plot, {x, y, width: area.width, height: area.height, markers: false, labels: isWide,
                lines: tuningSearches(lines).map(tuningSteps)});
        },
        csv: () => [['evaluation', 'phase', 'e_train'],
            ...lines.map(line => [line.evaluation, line.phase, line.e_train])],
    });
}

function tuningSteps(search) {
    let best = null;
    const points = [];
    for (const line of search.lines) {
        if (best && points.length) points.push({x: line.evaluation, y: best.e_train, text: [...tuningText(line),
            `best so far ${formatShare(best.e_train, 4)}`]});
        if (!best || line.e_train < best.e_train) best = line;
        points.push({x: line.evaluation, y: best.e_train, text: [...tuningText(line),
            `best so far ${formatShare(best.e_train, 4)}`]});
    }
    return {name: search.name, colour: search.colour, points};
}

/// Values of a parameter on an axis: numbers as they are, names beside each other.
function paramScale(values, width) {
    const known = distinct(values.filter(value => value !== null && value !== undefined), value => value);
    if (known.every(isNumber)) return {scale: makeScale(known, [0, width]), ticks: known.length <= 6 ? known : null};
    const names = known.map(String).sort((a, b) => a.localeCompare(b, undefined, {numeric: true}));
    return {scale: d3.scalePoint().domain(names).range([0, width]).padding(0.5), ticks: names};
}

function paramText(value) {
    return isNumber(value) ? formatTick(value) : value;
}

/// Where a value stands on the scale of paramScale().
function paramKey(value, scale) {
    return scale.step ? String(value) : value;
}

function tuningParam(grid, param, lines, range) {
    makeChart(grid, {
        id: `tuning-${param}`, title: param, height: 210, least: 300,
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 14, bottom: 46, left: 52});
            const {scale: x, ticks} = paramScale(lines.map(line => line[param]), area.width);
            const y = d3.scaleLinear().domain(range).range([area.height, 0]).clamp(true);
            drawAxes(area, x, y, {bottom: {title: param, ticks, format: paramText}, left: {title: 'error'}});
            const spots = lines.filter(line => line[param] !== null).map(line => ({
                px: x(paramKey(line[param], x)), py: y(line.e_train), line: {name: line.phase},
                point: {text: [...tuningText(line), `${param} ${line[param]}`]}, colour: tuningColour(line.phase)}));
            const layer = area.plot.append('g');
            for (const spot of spots)
                layer.append('circle').attr('cx', spot.px).attr('cy', spot.py).attr('r', 3).style('fill', spot.colour)
                    .style('opacity', 0.6);
            const best = tuningBest(lines);
            layer.append('circle').attr('cx', x(paramKey(best[param], x))).attr('cy', y(best.e_train)).attr('r', 6)
                .style('fill', 'none')
                .style('stroke', 'var(--bad)').style('stroke-width', 2);
            answerNearest(area.plot, layer, spots, area.width, area.height);
        },
        csv: () => [[param, 'phase', 'e_train'], ...lines.map(line => [line[param], line.phase, line.e_train])],
    });
}

const LANDSCAPE_CELLS = 12;
/// An error so near to the least is as good: a plateau of such cells says that the values are not chance.
const PLATEAU = 0.005;

/// Two parameters at a time: each cell of their ranges has the least error of the settings tried in it.
function tuningLandscapes(root, params, lines) {
    const numbers = params.filter(param => lines.every(line => line[param] === null || isNumber(line[param])));
    if (numbers.length < 2) return;
    root.append(element('h3', {}, 'Landscape of two parameters at a time'),
        element('p', {}, `The least error tried in each cell, whatever the other parameters; the redder, the more. ` +
            `Framed: at most ${PLATEAU} above the least of all. Many framed cells side by side are a plateau.`));
    const grid = chartGrid();
    root.append(grid);
    numbers.forEach((y, i) => numbers.slice(0, i).forEach(x => tuningLandscape(grid, x, y, lines)));
}

/// {i, j, best, tried} of each cell in which a setting was tried, cells counted along both axes.
function landscapeCells(xName, yName, lines, scales) {
    const indexOf = (value, {low, high}) =>
        Math.min(LANDSCAPE_CELLS - 1, Math.floor(LANDSCAPE_CELLS * (value - low) / (high - low)));
    const tried = lines.filter(line => isNumber(line[xName]) && isNumber(line[yName]));
    const at = line => `${indexOf(line[xName], scales.x)} ${indexOf(line[yName], scales.y)}`;
    return [...groupBy(tried, at)].map(([key, own]) => {
        const [i, j] = key.split(' ').map(Number);
        return {i, j, best: tuningBest(own), tried: own.length};
    });
}

function tuningLandscape(grid, xName, yName, lines) {
    const spanOf = name => ({low: d3.min(lines, line => line[name]), high: d3.max(lines, line => line[name])});
    const scales = {x: spanOf(xName), y: spanOf(yName)};
    const cells = landscapeCells(xName, yName, lines, scales);
    const least = tuningBest(lines).e_train;
    const worst = Math.max(...tuningRange(lines)) - least;
    makeChart(grid, {
        id: `landscape-${xName}-${yName}`, title: `${yName} over ${xName}`, height: 260, least: 300,
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 14, bottom: 46, left: 52});
            const x = d3.scaleLinear().domain([scales.x.low, scales.x.high]).range([0, area.width]);
            const y = d3.scaleLinear().domain([scales.y.low, scales.y.high]).range([area.height, 0]);
            drawAxes(area, x, y, {bottom: {title: xName}, left: {title: yName}});
            const [width, height] = [area.width / LANDSCAPE_CELLS, area.height / LANDSCAPE_CELLS];
            for (const {i, j, best, tried} of cells) {
                const above = best.e_train - least;
                const box = area.plot.append('rect').attr('x', i * width + 1).attr('y', area.height - (j + 1) * height + 1)
                    .attr('width', width - 2).attr('height', height - 2)
                    .style('fill', errorColour(above, worst)).style('stroke', above <= PLATEAU ? 'var(--ink)' : 'var(--rule)').style('stroke-width', above <= PLATEAU ? 2 : 0.5);
                answerText(box, [...tuningText(best), `${xName} ${formatTick(best[xName])}, ${yName} ${formatTick(best[yName])}`,
                    `least of ${count(tried, 'setting')} in this cell`]);
            }
        },
        csv: () => [[xName, yName, 'e_train', 'tried'],
            ...cells.map(({best, tried}) => [best[xName], best[yName], best.e_train, tried])],
    });
}

function tuningTable(root, table, lines) {
    makeTable(root, {
        name: 'evaluations', lines, most: 12, order: 'e_train.up', caption: 'Every evaluation, the best first.',
        columns: table.names.filter(name => lines.some(line => line[name] !== null)).map(name => ({
            key: name, title: name.replace(/_/g, ' '), value: line => line[name],
            isText: ['phase', 'drawn_by'].includes(name),
            text: line => (line[name] === null ? NOTHING : name === 'e_train' ? formatShare(line[name], 4)
                : isNumber(line[name]) ? formatTick(line[name]) : String(line[name])),
        })),
    });
}
