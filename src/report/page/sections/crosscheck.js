// The truth against an independent reference: how far the two agree.

addSection({
    id: 'crosscheck',
    title: 'Truth against the cross-check',
    intro: 'The cross-check finds the true lines a second time, by looking: once per pixel, and to both sides of ' +
        'every feature edge. Disagreement: the share of both lengths, class by class, that the other lacks within ' +
        '0.25 px, where a third construction sides against the truth. Where it sides with the truth, the ' +
        'cross-check abstains.',
    isThere: view => view.allRows.some(row => isNumber(row.reference_disagreement)),
    uses: ['sort.crosscheck'],
    draw(root, view) {
        const views = crosscheckedViews(view.allRows);
        root.append(element('p', {}, crosscheckSentence(views)));
        const disputed = views.filter(isDisagreement);
        if (disputed.length) {
            root.append(warningBox('Reference disagreement.', 'No method is scored on these views:',
                disputed.map(row => `${row.scene}, view ${row.view}: ` +
                    `${crosscheckPercent(row.reference_disagreement)}`)));
        }
        crosscheckTable(root, views);
    },
});

/// One row per view that was held against the cross-check.
function crosscheckedViews(rows) {
    const checked = rows.filter(row => isNumber(row.reference_disagreement));
    return [...groupBy(checked, row => `${row.scene}\n${row.view}`).values()].map(
        ofView => ofView.find(isDisagreement) || ofView[0]);
}

function isDisagreement(row) {
    return row.status.startsWith('reference_disagreement');
}

function crosscheckPercent(share) {
    return formatPercent(share, 3);
}

function crosscheckSentence(views) {
    const length = sumOf(views, 'crosscheck_px');
    const apart = d3.sum(views, row => row.reference_disagreement * row.crosscheck_px);
    const worst = views.reduce((a, b) => (b.reference_disagreement > a.reference_disagreement ? b : a));
    const abstained = d3.sum(views, row => row.crosscheck_abstained * row.crosscheck_px);
    return `The truth and its cross-check disagree on ${crosscheckPercent(length > 0 ? apart / length : 0)} of ` +
        `their lines over ${count(views.length, 'view')}. At worst they disagree on ` +
        `${crosscheckPercent(worst.reference_disagreement)} (${worst.scene}, ${worst.view}). ` +
        `The cross-check abstains on ${crosscheckPercent(length > 0 ? abstained / length : 0)}.`;
}

function crosscheckTable(root, views) {
    const lines = [...groupBy(views, row => row.scene)].map(([scene, ofScene]) => ({
        scene, views: ofScene.length, disputed: ofScene.filter(isDisagreement).length,
        worst: ofScene.reduce((a, b) => (b.reference_disagreement > a.reference_disagreement ? b : a)),
    }));
    makeTable(root, {
        name: 'crosscheck', lines, order: 'disagreement.down', most: 30,
        columns: [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene},
            {key: 'views', title: 'views', value: line => line.views},
            {key: 'worst', title: 'worst view', isText: true, value: line => line.worst.view},
            {key: 'disagreement', title: 'disagreement', value: line => line.worst.reference_disagreement,
                text: line => crosscheckPercent(line.worst.reference_disagreement)},
            {key: 'abstained', title: 'abstains on', value: line => line.worst.crosscheck_abstained,
                text: line => crosscheckPercent(line.worst.crosscheck_abstained)},
            {key: 'length', title: 'of lines px, both ways', value: line => line.worst.crosscheck_px,
                text: line => formatNumber(line.worst.crosscheck_px)},
            {key: 'status', title: 'status', isText: true, value: line => line.disputed,
             node: line => (line.disputed ? element('strong', {}, `disagreement in ${line.disputed}`) : 'agreed')},
        ],
    });
}
