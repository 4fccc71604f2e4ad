// Skips: work that a scene does not need, how much of it was left out, and what that is worth.

/// Less than this factor is within what repeated runs differ by.
const SKIP_WORTHWHILE = 1.05;

addSection({
    id: 'skips',
    title: 'Skips',
    intro: 'Work that was left out because the image does not need it: the share over all views, below it the ' +
        'largest share of one view and where that was. A skip never changes a bit of an image.',
    isThere: view => skipCells(view).length > 0 ||
        skipKinds(view.run).some(kind => view.rows.some(row => isNumber(row[kind.of]))),
    uses: ['sort.skips*'],
    draw(root, view) {
        const rows = view.rows.filter(row => row.status === 'ok' && isNumber(row.skip_attributes_of));
        if (rows.length) {
            skipShares(root, view, rows);
            root.append(termList(skipKinds(view.run).map(kind => [kind.name.replace(/_/g, ' '), kind.doc])));
            skipForbidden(root, rows);
        }
        skipStudy(root, view);
    },
});

/// The skips that rows have columns for: {name, count, of, unit, doc}.
function skipKinds(run) {
    const docs = (window.columnDocs || {})['rows.csv'] || {};
    return run.table('rows.csv').names.filter(name => name.startsWith('skip_') && !name.endsWith('_of')).map(name => ({
        name: name.slice(5), count: name, of: `${name}_of`,
        unit: (docs[name] || {}).unit || '',
        doc: ((docs[name] || {}).doc || '').replace(/^left \w+ in a frame: /, ''),
    }));
}

/// A method's share of one skip over rows, and the row with the largest; null where it does not apply.
function skipShare(rows, kind) {
    const apply = rows.filter(row => row[kind.of] > 0);
    if (apply.length === 0) return null;
    const share = row => row[kind.count] / row[kind.of];
    const most = apply.reduce((a, b) => (share(b) > share(a) ? b : a));
    return {share: sumOf(apply, kind.count) / sumOf(apply, kind.of), most, mostShare: share(most)};
}

function skipPercent(share) {
    if (!isNumber(share)) return NOTHING;
    return share > 0 && share < 0.001 ? '< 0.1 %' : formatPercent(share);
}

function skipShares(root, view, rows) {
    const columns = skipKinds(view.run).map(kind => ({
        key: kind.name, title: kind.name.replace(/_/g, ' '), help: `${kind.doc} Counted in ${kind.unit}.`,
        value: group => (skipShare(group.lines, kind) || {share: null}).share,
        node: group => {
            const found = skipShare(group.lines, kind);
            if (!found || found.share === 0) return element('span', {}, found ? '0' : NOTHING);
            return element('span', {}, skipPercent(found.share),
                element('small', {}, `${skipPercent(found.mostShare)} in`),
                           element('small', {}, `${found.most.scene}, ${found.most.view}`));
        },
        rows: group => {
            const found = skipShare(group.lines, kind);
            return found && found.share > 0 ? [found.most] : [];
        },
    }));
    makeTable(root, {name: 'skips', lines: byMethod(view.run, rows), lineClass: baselineClass,
        columns: [infoColumn(), ...columns]});
}

function skipForbidden(root, rows) {
    const names = distinct(rows, row => row.skips_off).filter(Boolean).map(text => text.split(';').join(', '));
    if (names.length === 0) return;
    root.append(element('p', {class: 'note'},
        `Switched off while these rows were timed: ${names.join('; or ').replace(/_/g, ' ')}. Each view is drawn ` +
        'again and again to be timed, so reusing tiles that did not change would make every drawing but the first ' +
        'nearly free. That skip is measured on a sequence.'));
}

// ---- What each skip is worth --------------------------------------------------------------

/// Values of the axis skips_off.
const SKIP_ARMS = {1: 'on', 2: 'one_off', 3: 'all_off'};

/// The cells of the study, with `arm` and with the `skip` that their scene was made for: the one that is
/// off where only that is.
function skipCells(view) {
    const rows = view.run.table('rows.csv').lines.filter(row => row.study === 'skips' && view.isMethodShown(row.method));
    const off = (scene, value) => (rows.find(row => row.scene === scene && row.value === value) || {skips_off: null})
        .skips_off;
    const names = text => (text || '').split(';').filter(Boolean);
    const skips = new Map(distinct(rows, row => row.scene).map(scene => [scene,
        names(off(scene, 2)).find(name => !names(off(scene, 1)).includes(name)) || '']));
    return rows.map(row => Object.assign(Object.create(row), {arm: SKIP_ARMS[row.value], skip: skips.get(row.scene)}));
}

function skipStudy(root, view) {
    const lines = skipCells(view);
    if (lines.length === 0) {
        root.append(element('p', {class: 'note'}, 'What each skip saves in time was not measured: the option ',
            element('code', {}, '--skip-study'), ' does that.'));
        return;
    }
    const [ofSkips, ofViews] = [lines.filter(line => line.skip), lines.filter(line => !line.skip)];
    root.append(element('h3', {}, 'What each skip saves'), element('p', {class: 'note'},
        'One scene per skip, made for it. How many times as fast a frame is with the skip as without it (least ' +
        'times, without → with), while everything else is skipped in both; then the share that it left out, and ' +
        'the time with no skip at all. ' +
        `Bold: ${SKIP_WORTHWHILE} and more. ` +
        'Images were compared bit for bit.'));
    skipStudyTable(root, view, 'skips-worth', ofSkips);
    if (ofViews.length === 0) return;
    root.append(element('h3', {}, 'An empty view, a small object, a full view'), element('p', {class: 'note'},
        'One object, seen from three places. How many times as fast a frame is with all skips as with none.'));
    skipStudyTable(root, view, 'skips-views', ofViews);
}

function skipStudyTable(root, view, name, lines) {
    const scenes = [...groupBy(lines, line => line.scene)].map(([scene, ofScene]) => ({
        scene, skip: ofScene[0].skip || '', triangles: ofScene[0].triangles,
        arms: new Map([...groupBy(ofScene, line => line.method)].map(([method, ofMethod]) => [method,
            Object.fromEntries(ofMethod.map(line => [line.arm, line]))])),
    }));
    const methods = byMethod(view.run, lines);
    makeTable(root, {
        name, lines: scenes,
        columns: [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene,
                text: line => line.scene.replace(/_/g, ' ')},
            ...(scenes.some(line => line.skip) ? [{key: 'skip', title: 'skip', isText: true,
                value: line => line.skip, text: line => line.skip.replace(/_/g, ' ')}] : []),
            {key: 'triangles', title: 'triangles', value: line => line.triangles},
            ...methods.map(method => ({
                key: method.name, title: method.name, value: line => skipGain(line.arms.get(method.name)),
                node: line => skipStudyCell(line.arms.get(method.name), line.skip),
            })),
        ],
    });
}

function skipIsTimed(line) {
    return Boolean(line && line.status === 'ok' && line.draw_ns_min > 0);
}

/// How many times as fast a frame is with the skip (or all skips) as without; null where it was not
/// timed, and for work that is the same in both.
function skipGain(arms) {
    if (!arms || !skipIsTimed(arms.on)) return null;
    const without = arms.one_off || arms.all_off;
    if (!skipIsTimed(without)) return null;
    if (arms.one_off && !(arms.on[`skip_${arms.on.skip}`] > 0)) return null;
    return without.draw_ns_min / arms.on.draw_ns_min;
}

function skipStudyCell(arms, skip) {
    const failed = Object.values(arms || {}).find(line => line.status !== 'ok');
    if (failed) return element('strong', {title: failed.status}, 'failed');
    if (!arms || !skipIsTimed(arms.on)) return NOTHING;
    const ms = line => (skipIsTimed(line) ? `${formatMs(line.draw_ns_min * 1e-6)} ms` : NOTHING);
    if (skip && !(arms.on[`skip_${skip}_of`] > 0)) return element('span',
        {title: 'This method has nothing of the kind to skip'}, NOTHING);
    const gain = skipGain(arms);
    if (gain === null) return element('span', {}, '0', element('small', {}, ms(arms.on)),
        element('small', {}, 'nothing skipped'));
    const text = `× ${gain.toFixed(gain < 10 ? 2 : 0)}`;
    const without = arms.one_off || arms.all_off;
    return element('span', {}, gain >= SKIP_WORTHWHILE ? element('strong', {}, text) : text,
        element('small', {}, `${ms(without)} → ${ms(arms.on)}`),
        skip ? element('small', {},
            `${skipPercent(shareOf(arms.on[`skip_${skip}`], arms.on[`skip_${skip}_of`]))} skipped`) : null,
        skip ? element('small', {}, `no skips: ${ms(arms.all_off)}`) : null);
}
