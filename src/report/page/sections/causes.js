// Where the error goes: missing and false pixels by cause.

state.define('causes.share', true);

addSection({
    id: 'causes',
    title: 'Where the error goes',
    intro: 'Each wrong pixel has one cause, and those that are known are drawn. Bars to the left are missing pixels, bars to the right false ones. ' +
        'Unmatched duplicates and unmatched truth are pixels of a correctly found line that one-to-one matching could not ' +
        'pair, because the drawn line is thick, ragged or short.',
    isThere: view => view.rows.some(row => row.false_negatives !== null && isScored(row)),
    uses: ['causes.*', 'sort.causes'],
    draw(root, view) {
        const lines = view.contestants.map(causeTotals).filter(line => line.truth > 0)
            .sort((a, b) => a.missing + a.false - b.missing - b.false);
        const isShare = state.get('causes.share');
        const unit = line => (isShare ? 100 / line.truth : 1);
        makeChart(root, {
            id: 'causes', title: `Wrong pixels of a known cause${isShare ? ', % of the true ones' : ''}`,
            height: 30 + 22 * lines.length + 46,
            controls: [choiceButtons('Unit', [[true, '% of truth'], [false, 'pixels']], isShare, on => state.set({'causes.share': on}))],
            draw: chart => drawCauseChart(chart, lines, unit, isShare),
            csv: () => [['method', 'truth_px', 'unmatched_truth', 'unmatched_duplicates', ...CAUSES.map(c => `${c.kind}_${c.name}`)],
                ...lines.map(line => [line.method, line.truth, line.unmatched_truth, line.unmatched_duplicates,
                                      ...CAUSES.map(c => line.causes[c.name])])],
        });
        const unknown = lines.filter(line => line.causes.undeclared > 0);
        if (unknown.length) root.append(element('p', {class: 'note'}, 'Of these methods, which declare no code, most misses have no known cause: ' +
            `${unknown.map(line => `${line.method} ${formatPercent(line.causes.undeclared / line.missing, 0)}`).join(', ')}.`));
        root.append(element('ul', {class: 'legend'}, CAUSES.filter(cause => isKnownCause(cause) && lines.some(line => line.causes[cause.name] > 0))
            .map(cause => element('li', {}, element('i', {style: `background:${rgbText(cause.rgb)}`}), cause.text))));
        const share = (line, value) => `${((100 * value) / line.truth).toFixed(2)} %`;
        makeTable(root, {
            name: 'causes', lines, order: '', columns: [
                methodColumn(line => line.info, {rows: line => line.rows}),
                {key: 'missing', title: 'missing', value: line => line.missing, text: line => share(line, line.missing), group: 'of the true pixels', best: 'low'},
                {key: 'false', title: 'false', value: line => line.false, text: line => share(line, line.false), group: 'of the true pixels', best: 'low'},
                {key: 'unmatched_truth', title: 'unmatched truth', value: line => line.unmatched_truth, text: line => share(line, line.unmatched_truth), group: 'of the true pixels'},
                {key: 'unmatched_duplicates', title: 'unmatched duplicates', value: line => line.unmatched_duplicates, text: line => share(line, line.unmatched_duplicates), group: 'of the true pixels'},
                ...CAUSES.filter(cause => lines.some(line => line.causes[cause.name] > 0)).map(cause => ({
                    key: cause.name, title: isKnownCause(cause) ? cause.name.replace(/_/g, ' ') : 'cause not known', help: cause.text,
                    group: cause.kind === 'false_positives' ? 'false, px' : 'missing, px',
                    value: line => line.causes[cause.name], text: line => formatNumber(line.causes[cause.name]),
                })).sort((a, b) => a.group.localeCompare(b.group)),
            ],
        });
    },
});

function causeTotals(summary) {
    const total = name => d3.sum(summary.rows, row => row[name]);
    return {
        method: summary.method, info: summary.info, rows: summary.rows, isBaseline: summary.isBaseline,
        truth: total('n_truth'), missing: total('false_negatives'), false: total('false_positives'),
        unmatched_truth: total('unmatched_truth'), unmatched_duplicates: total('unmatched_duplicates'),
        causes: Object.fromEntries(CAUSES.map(cause => [cause.name, total(`${cause.kind}_${cause.name}`)])),
    };
}

function drawCauseChart(chart, lines, unit, isShare) {
    const {plot, width, height} = plotArea(chart, {left: plotLabelWidth(lines.map(line => line.info)), right: 16, top: 8, bottom: 46});
    const known = CAUSES.filter(isKnownCause);
    const most = kind => d3.max(lines, line => unit(line) * d3.sum(known.filter(cause => cause.kind === kind), cause => line.causes[cause.name]));
    const x = d3.scaleLinear().domain([-most('false_negatives') * 1.02 || -1, most('false_positives') * 1.02 || 1]).range([0, width]);
    drawAxis(plot, x, {side: 'bottom', title: `missing ←   ${isShare ? '% of the true pixels' : 'pixels'}   → false`,
                       length: width, across: height, format: value => formatNumber(Math.abs(value))});
    const band = height / lines.length;
    drawNames(plot, lines.map(line => line.info), band);
    lines.forEach((line, i) => {
        const from = {false_negatives: 0, false_positives: 0};
        const bar = plot.append('g').attr('class', 'point');
        for (const cause of known) {
            const value = unit(line) * line.causes[cause.name];
            if (!value) continue;
            const start = from[cause.kind];
            from[cause.kind] += value;
            const [a, b] = cause.kind === 'false_positives' ? [start, start + value] : [-start - value, -start];
            bar.append('rect').attr('class', 'cause').attr('x', x(a)).attr('width', Math.max(0.5, x(b) - x(a))).attr('y', i * band + 3).attr('height', band - 6)
                .style('fill', rgbText(cause.rgb)).append('title').text(`${cause.text}: ${value.toFixed(isShare ? 2 : 0)}${isShare ? ' %' : ' px'}`);
        }
        answerPointer(bar, line.rows, [`${line.method}: missing ${formatNumber(line.missing)} px, false ${formatNumber(line.false)} px of ${formatNumber(line.truth)} true ones`]);
    });
    plot.append('line').attr('class', 'zero').attr('x1', x(0)).attr('x2', x(0)).attr('y1', 0).attr('y2', height);
}
