// The linear bound: the most that any four weights could reach on a scene.

addSection({
    id: 'bound',
    title: 'The best that any weights could reach',
    intro: 'A packed code adds depth and normal with four weights. F upper: an estimate of ' +
        'what no weights exceed (how much ink thinning leaves is measured). F found: some weights reach it. F of the method: its own score. F model: its weights, scored by the bound’s more ' +
        'lenient rule, which forgives extra pixels and lines that share one drawn pixel.',
    isThere: view => view.run.has('bound.csv'),
    uses: ['sort.bound'],
    draw(root, view) {
        const lines = view.run.joined('bound.csv').filter(line => view.isMethodShown(line.method))
            .map(line => Object.assign(line, {info: view.run.methods.get(line.method)}));
        if (lines.length === 0) {
            root.append(element('p', {class: 'note'}, 'The filters leave no method of this study.'));
            return;
        }
        for (const [name, ofMethod] of groupBy(lines, line => line.method)) boundChart(root, name, ofMethod);
        boundTable(root, lines);
    },
});

const BOUND_MARKS = [
    {field: 'f_2px', text: 'F of the method', colour: 'var(--ink)', marker: 'circle'},
    {field: 'f_model', text: 'F model', colour: 'var(--family-packed)', marker: 'square'},
    {field: 'f_found', text: 'F found', colour: 'var(--family-ids)', marker: 'up'},
    {field: 'f_upper', text: 'F upper', colour: 'var(--family-full)', marker: 'down'},
];

function boundChart(root, name, lines) {
    root.append(colourLegend(BOUND_MARKS.map(mark => [mark.colour, mark.text])));
    makeChart(root, {
        id: `bound-${name}`, title: `${name}: what its weights reach, and what weights could`, height: 60 +
            28 * lines.length, least: 300,
        draw: chart => {
            const left = Math.min(24 + 7 * d3.max(lines, line => line.scene.length), 0.4 * chart.width);
            const area = plotArea(chart, {top: 8, right: 20, bottom: 46, left});
            const values = lines.flatMap(line => BOUND_MARKS.map(mark => line[mark.field])).filter(isNumber);
            const x = d3.scaleLinear().domain([Math.max(0, d3.min(values) - 0.03), 1]).range([0, area.width]);
            const y = d3.scalePoint().domain(lines.map(line => line.scene)).range([0, area.height]).padding(0.6);
            drawAxes(area, x, null, {bottom: {title: 'F'}});
            for (const line of lines) boundMarks(area.plot, line, x, y(line.scene));
        },
        csv: () => [['method', 'scene', ...BOUND_MARKS.map(mark => mark.field)], ...lines.map(
            line => [name, line.scene, ...BOUND_MARKS.map(mark => line[mark.field])])],
    });
}

function boundMarks(plot, line, x, at) {
    plot.append('text').attr('class', 'tick').attr('x', -8).attr('y', at + 4).attr('text-anchor', 'end')
        .text(line.scene);
    plot.append('line').attr('x1', x(line.f_found)).attr('x2', x(line.f_upper)).attr('y1', at).attr('y2', at)
        .style('stroke', 'var(--rule)').style('stroke-width', 5);
    for (const mark of BOUND_MARKS.filter(m => isNumber(line[m.field]))) {
        const shape = plot.append('path').attr('d', MARKERS[mark.marker])
            .attr('transform', `translate(${x(line[mark.field])},${at})`)
            .style('fill', mark.colour).style('stroke', 'var(--paper)');
        answerText(shape, [line.scene, `${mark.text} ${formatShare(line[mark.field], 4)}`]);
    }
}

function boundTable(root, lines) {
    const weight = key => ({key, title: key, group: 'weights found, over the threshold', value: line => line[key],
        text: line => formatSigned(line[key], 2)});
    makeTable(root, {
        name: 'bound', lines,
        columns: [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene}, infoColumn(),
            {key: 'views', title: 'views', value: line => line.views},
            ...BOUND_MARKS.map(mark => shareColumn(mark.field, mark.text, line => line[mark.field], {best: null})),
            shareColumn('gap', 'gap', line => line.gap,
                {best: null, help: 'F upper less F found: what the search leaves open'}),
            {key: 'boxes', title: 'boxes searched', value: line => line.boxes,
                help: 'Boxes of weights that were looked at'},
            ...['depth', 'nx', 'ny', 'nz'].map(weight),
            {key: 'found', title: 'true px found', value: line => line.found}, {key: 'far', title: 'far positives',
                value: line => line.far_positives},
        ],
    });
}
