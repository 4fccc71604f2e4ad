// Place and width: what F forgives, because it thins lines and allows 2 px.

addSection({
    id: 'place',
    title: 'Place and width',
    intro: 'What F forgives, because it thins lines and allows 2 px. Cracks: without thinning, a drawn pixel is ' +
        'right if a true line runs between it and one of its four neighbours. Offset: distance of thinned pixels ' +
        'from the nearest true curve, positive towards its empty side. Width: across the true curves. Far ' +
        'positives: drawn pixels, not thinned, farther than 2 px from every true one.',
    isThere: view => view.rows.some(row => isNumber(row.crack_truth)),
    uses: ['sort.place'],
    draw(root, view) {
        const methods = placeMethods(view);
        placeChart(root, methods);
        placeTable(root, methods);
    },
});

function placeMethods(view) {
    const rows = view.rows.filter(row => isScored(row) && isNumber(row.crack_truth));
    return byMethod(view.run, rows).map(method => {
        const sum = field => sumOf(method.lines, field);
        const precision = shareOf(sum('crack_beside'), sum('crack_drawn'));
        const recall = shareOf(sum('crack_found'), sum('crack_truth'));
        return {
            ...method, precision, recall,
            f: precision === null || recall === null || precision + recall === 0
                ? null : (2 * precision * recall) / (precision + recall),
            offset: momentsOf(sum('offset_n'), sum('offset_sum_px'), sum('offset_sum_sq_px2')),
            width: momentsOf(sum('width_n'), sum('width_sum_px'), sum('width_sum_sq_px2')),
            far: shareOf(sum('far_positive_px'), sum('positive_px')),
        };
    });
}

/// Per method where its lines lie beside the true ones, and how wide they are.
function placeChart(root, methods) {
    const shown = methods.filter(method => method.offset);
    if (shown.length === 0) return;
    const grid = chartGrid();
    root.append(grid);
    placeDots(grid, shown, {id: 'offset', title: 'Offset, mean ± spread',
        unit: 'px; positive: to the empty side', of: 'offset', isSigned: true});
    placeDots(grid, shown.filter(method => method.width),
        {id: 'width', title: 'Width, mean ± spread', unit: 'px', of: 'width'});
}

function placeDots(grid, methods, {id, title, unit, of, isSigned = false}) {
    makeChart(grid, {
        id: `place-${id}`, title, height: barsHeight(methods), least: 300,
        draw: chart => {
            const left = Math.min(plotLabelWidth(methods), 0.4 * chart.width);
            const area = plotArea(chart, {top: 8, right: 16, bottom: 46, left});
            const values = methods.flatMap(m => [m[of].mean - m[of].spread, m[of].mean + m[of].spread]);
            const x = makeScale(values, [0, area.width], {includesZero: true});
            const y = d3.scaleBand().domain(methods.map(m => m.name)).range([0, area.height]).padding(0.3);
            drawAxes(area, x, null, {bottom: {title: unit}});
            area.plot.append('line').attr('class', 'zero').attr('x1', x(0)).attr('x2', x(0)).attr('y1', 0)
                .attr('y2', area.height);
            for (const method of methods) placeDot(area.plot, method, method[of], x, y, isSigned);
        },
        csv: () => [['method', 'mean_px', 'spread_px', 'rms_px'],
            ...methods.map(m => [m.name, m[of].mean, m[of].spread, m[of].rms])],
    });
}

function placeDot(plot, method, moments, x, y, isSigned) {
    const middle = y(method.name) + y.bandwidth() / 2;
    const group = plot.append('g').attr('class', 'point').attr('data-method', method.name);
    plot.append('text').attr('class', 'tick').attr('x', -8).attr('y', middle + 4).attr('text-anchor', 'end')
        .text(method.name);
    group.append('line').attr('class', 'interval').attr('x1', x(moments.mean - moments.spread))
        .attr('x2', x(moments.mean + moments.spread))
        .attr('y1', middle).attr('y2', middle).style('stroke', colourOf(method.info));
    group.append('circle').attr('class', 'catch').attr('cx', x(moments.mean)).attr('cy', middle).attr('r', 11)
        .style('fill', 'transparent');
    group.append('path').attr('d', markerOf(method.info)).attr('transform', `translate(${x(moments.mean)},${middle})`)
        .call(markerStyle, method.info);
    answerPointer(group, method.lines,
        [`mean ${placePx(moments.mean, isSigned)} px, spread ${placePx(moments.spread)} px`]);
}

/// px with two digits.
function placePx(value, isSigned = false) {
    return isSigned ? formatSigned(value, 2) : formatShare(value, 2);
}

function placeTable(root, methods) {
    const rows = method => (method.isBaseline ? null : method.lines);
    const moment = (key, of, part, group, isSigned = false) => ({
        key, title: part, group, value: m => (m[of] ? m[of][part] : null),
            text: m => placePx(m[of] ? m[of][part] : null, isSigned),
    });
    makeTable(root, {
        name: 'place', lines: methods, lineClass: baselineClass, order: 'crack_f.down',
        columns: [
            methodColumn(line => line.info, {rows}),
            shareColumn('crack_f', 'F', m => m.f, {group: 'cracks', rows}),
            shareColumn('crack_precision', 'precision', m => m.precision, {group: 'cracks'}),
            shareColumn('crack_recall', 'recall', m => m.recall, {group: 'cracks'}),
            moment('offset_mean', 'offset', 'mean', 'offset px', true), moment('offset_spread', 'offset', 'spread',
                'offset px'),
            moment('offset_rms', 'offset', 'rms', 'offset px'),
            moment('width_mean', 'width', 'mean', 'width px'), moment('width_spread', 'width', 'spread', 'width px'),
            shareColumn('far', 'far positives', m => m.far,
                {best: 'low', help: 'Share of the drawn pixels farther than 2 px from every true one'}),
        ],
    });
}
