// The cube roll: which creases a method loses while the camera rolls once round, and where its
// declared weights predict it.

state.define('roll.all', false);

const ROLL_COLOURS = ['var(--family-packed)', 'var(--family-full)', 'var(--family-ids)'];

addSection({
    id: 'roll',
    title: 'The cube roll',
    intro: 'A camera rolls once round in front of a cube. The three visible creases keep their place on the cube ' +
        'and turn in the image. Lines: the share of each crease that is drawn (recall). Dashed: the angles at ' +
        'which a method’s declared weights make both sides of a crease equal, computed from weights and geometry ' +
        'alone. Shaded: angles at which the change is too small for the threshold. Dots: recall in a frame at ' +
        'exactly such an angle; what shows there is the kink of the depth.',
    isThere: view => view.run.has('creases.csv'),
    uses: ['roll.*', 'sort.roll*'],
    draw(root, view) {
        const curves = rollCurves(view);
        const isShown = method => state.get('roll.all') || method.curves.some(curve => curve.isPredicted);
        const shown = curves.filter(isShown);
        root.append(element('div', {class: 'tools'}, choiceButtons('Methods', [
            [false, 'Methods that declare a code'], [true, 'All methods']], state.get('roll.all'),
                all => state.set({'roll.all': all}))));
        root.append(colourLegend(ROLL_COLOURS.map((colour, i) => [colour, `crease ${i + 1}`])));
        if (shown.length === 0) root.append(element('p', {class: 'note'}, 'No method here declares a code.'));
        const grid = chartGrid();
        root.append(grid);
        for (const method of shown) rollChart(grid, method);
        rollTable(root, curves);
        rollVanishingTable(root, view);
    },
});

/// Per method its curves: {crease, isPredicted, samples: [{deg, recall, isBlind}], vanishing}.
function rollCurves(view) {
    const vanishing = groupBy(view.run.joined('vanishing.csv'), line => `${line.method} ${line.crease}`);
    const lines = view.run.joined('creases.csv').filter(line => view.isMethodShown(line.method));
    return byMethod(view.run, lines).map(method => ({
        ...method,
        curves: [...groupBy(method.lines, line => `${line.method} ${line.crease}`)].map(([key, ofCrease]) => ({
            crease: ofCrease[0].crease,
            isPredicted: isNumber(ofCrease[0].predicted_step),
            samples: ofCrease.map(line => ({
                deg: line.value, recall: line.length_px > 0 ? line.covered_px / line.length_px : 0,
                isBlind: line.predicted_blind === true || line.predicted_blind === 'true',
            })),
            vanishing: vanishing.get(key) || [],
        })),
    }));
}

function rollChart(grid, method) {
    makeChart(grid, {
        id: `roll-${method.name}`, title: method.name, height: 190, least: 300,
        draw: chart => {
            const forEach = drawPart => (area, x, y) => method.curves.forEach(curve => drawPart(area.plot, method,
                curve, x, y));
            plotLines(chart, {
                lines: method.curves.map(curve => rollLine(method, curve)), markers: false, labels: false, room_px: 40,
                x: range => d3.scaleLinear().domain([0, 360]).range(range), y: range => d3.scaleLinear()
                    .domain([0, 1]).range(range),
                left: {title: 'recall', ticks: [0, 0.5, 1]},
                bottom: {title: 'roll of the camera', ticks: [0, 90, 180, 270, 360], format: deg => `${deg}°`},
                under: (...place) => [rollBlind, rollVanishing].forEach(drawPart => forEach(drawPart)(...place)),
                over: forEach(rollDots),
            });
        },
        csv: () => [['method', 'crease', 'roll_deg', 'recall', 'predicted_blind'], ...method.curves.flatMap(
            curve => curve.samples.map(s => [method.name, curve.crease + 1, s.deg, s.recall, s.isBlind]))],
    });
}

function rollLine(method, curve) {
    return {
        name: `crease ${curve.crease + 1}`, colour: ROLL_COLOURS[curve.crease % 3],
        points: curve.samples.map(sample => ({
            x: sample.deg, y: sample.recall,
            text: [`${method.name}, crease ${curve.crease + 1}`,
                `recall ${formatShare(sample.recall)} at ${formatNumber(sample.deg)}°`],
        })),
    };
}

/// Bands of angles at which the filter cannot show a crease.
function rollBlind(plot, method, curve, x, y) {
    const height = y(0);
    const half = 180 / curve.samples.length;
    for (const sample of curve.samples.filter(s => s.isBlind)) {
        const [from, to] = [Math.max(0, sample.deg - half), Math.min(360, sample.deg + half)];
        plot.append('rect').attr('x', x(from)).attr('width', x(to) - x(from)).attr('y', 0).attr('height', height)
            .style('fill', ROLL_COLOURS[curve.crease % 3]).style('opacity', 0.16);
    }
}

function rollVanishing(plot, method, curve, x, y) {
    for (const at of curve.vanishing) {
        plot.append('line').attr('x1', x(at.predicted_deg)).attr('x2', x(at.predicted_deg)).attr('y1', -5)
            .attr('y2', y(0))
            .style('stroke', ROLL_COLOURS[curve.crease % 3]).style('stroke-width', 1.2).style('stroke-dasharray',
                '4 3');
    }
}

function rollDots(plot, method, curve, x, y) {
    for (const at of curve.vanishing.filter(line => isNumber(line.recall_there))) {
        const dot = plot.append('circle').attr('cx', x(at.predicted_deg)).attr('cy', y(at.recall_there)).attr('r', 4)
            .style('fill', ROLL_COLOURS[curve.crease % 3]).style('stroke', 'var(--paper)');
        answerText(dot, [`${method.name}, crease ${curve.crease + 1}`,
            `predicted to vanish at ${at.predicted_deg.toFixed(1)}°`,
                         `measured ${isNumber(at.measured_deg) ? `at ${at.measured_deg.toFixed(1)}°` : 'nowhere'}`,
                         `recall there ${formatShare(at.recall_there, 2)}`]);
    }
}

/// Least and mean recall of each crease.
function rollTable(root, methods) {
    const ofCrease = (method, crease) => method.curves.find(curve => curve.crease === crease);
    const recalls = (method, crease) => (ofCrease(method, crease) ? ofCrease(method,
        crease).samples.map(s => s.recall) : []);
    const column = (crease, kind, take) => shareColumn(`${kind}_${crease}`, kind, method => {
        const values = recalls(method, crease);
        return values.length ? take(values) : null;
    }, {group: `recall, crease ${crease + 1}`});
    makeTable(root, {
        name: 'roll', lines: methods, lineClass: baselineClass,
        columns: [infoColumn(), ...[0, 1, 2].flatMap(crease => [column(crease, 'least', d3.min),
            column(crease, 'mean', d3.mean)]),
            {key: 'blind', title: 'predicted loss', isText: true, value: method => rollBlindWords(method)}],
    });
}

function rollBlindWords(method) {
    if (!method.curves.some(curve => curve.isPredicted)) return 'no code declared';
    const words = method.curves.map(curve => {
        if (curve.vanishing.length) return `crease ${curve.crease + 1} at ` +
            `${curve.vanishing.map(at => `${at.predicted_deg.toFixed(0)}°`).join(', ')}`;
        return curve.samples.every(sample => sample.isBlind) ? `crease ${curve.crease + 1} at every angle`
            : `crease ${curve.crease + 1} at none`;
    });
    return words.join('; ');
}

function rollVanishingTable(root, view) {
    const lines = view.run.joined('vanishing.csv').filter(line => view.isMethodShown(line.method))
        .map(line => Object.assign(line, {info: view.run.methods.get(line.method)}));
    if (lines.length === 0) return;
    const degrees = key => ({value: line => line[key], text: line => (isNumber(line[key])
        ? `${line[key].toFixed(1)}°` : NOTHING)});
    makeTable(root, {
        name: 'roll-vanishing', lines, most: 24,
            caption: 'Angles at which a code has no step across a crease, and where the crease was lost.',
        columns: [infoColumn(), {key: 'crease', title: 'crease', value: line => line.crease + 1},
            {key: 'predicted', title: 'predicted', ...degrees('predicted_deg')},
            {key: 'measured', title: 'measured',
                help: 'Middle of the angles near it at which less than half was drawn', ...degrees('measured_deg')},
            {key: 'error', title: 'difference', value: line => line.error_deg,
                text: line => (isNumber(line.error_deg) ? `${formatSigned(line.error_deg, 1)}°` : NOTHING)},
            shareColumn('recall_there', 'recall there', line => line.recall_there,
                {help: 'Share of the crease drawn at exactly that angle'})],
    });
}
