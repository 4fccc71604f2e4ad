// How to read the page, and where its numbers come from.

state.define('about.table', 'rows.csv');
state.define('about.method', '');

addSection({
    id: 'about',
    title: 'How to read this',
    intro: null,
    uses: ['about.*', 'sort.about*'],
    draw(root, view) {
        root.append(termList(aboutTerms()));
        root.append(element('h3', {}, 'Where the numbers come from'), aboutProvenance(view.run));
        aboutParameters(root, view);
        aboutColumns(root, view.run);
    },
});

/// What the words of the page mean.
function aboutTerms() {
    return [
        ['F', 'joins precision and recall: F = 2 K / (drawn + true), where K is the largest number of drawn and ' +
            'true pixels that can be paired one to one, at most 2 px (or 1 px) apart. Lines are thinned first, ' +
            'and 6 px at the frame do not count.'],
        ['soft F', 'F of ink: 2 Σ min(I, C) / Σ (I + C), where I is the share of a pixel that is drawn and C the share that true ' +
            'lines of the run’s width cover. Black-and-white lines cover their pixels whole.'],
        ['error', '1 − F, or 1 − soft F.'],
        ['precision', 'the share of drawn pixels that are matched.'],
        ['recall', 'the share of true pixels that are matched.'],
        ['pooled', 'the counts of all views are added before they are divided, so every pixel counts alike. A cell ' +
            'that failed is in no number.'],
        ['mean of scenes (macro)', 'the mean of each scene’s own F, so every scene counts alike.'],
        ['mean of kinds', 'the mean of F pooled over the scenes of each kind (scans, vehicles, ...), so every kind counts alike.'],
        ['training, held-out, real', 'the three parts of a suite. Methods were tuned, if at all, on training scenes ' +
            'only. Held-out scenes are made by code too, so they are like the training scenes in ways that nobody ' +
            'chose. Real models are files. A conclusion holds on the parts it names and on no other.'],
        ['interval', 'where a value would lie for other scenes like these: scenes are drawn anew 2000 ' +
            'times with replacement, each with all its views, because views of one scene are hard or easy ' +
            'together (the bootstrap t). It is called by what it is worth: of the catalogue’s scenes it holds the truth in 80 of 100 cases with 6 ' +
            'scenes, in 85 with 16 and in 90 with 36; in fewer where most of the error sits in one scene. Fewer than six give none.'],
        ['answer', 'of the methods within the time budget, the cheapest whose F (soft F where ink was scored) is at most a margin (0.01 unless the run was ' +
            'asked for another) below the best of them. It is held against the most exact, or the next if it is that itself.'],
        ['paired difference', 'two methods compared on the same views, scenes drawn anew for both together. Of ' +
            'many intervals some miss by chance; so a method leads only by the interval that is to ' +
            'hold together with those of all pairs (the maximum-t method of Westfall and Young, 1993).'],
        ['draw ms', 'the lower quartile of the processor time of a frame at the best speed of the machine, of ' +
            'several threads of its time on the wall; over several views their median. Bars along the time axis are quartiles over views.'],
        ['baselines', 'four rows that are not methods. none: an empty image. sampled: one exact sample a ' +
            'pixel: the true lines as the surfaces at pixel centres tell them. exact_corner: the same of pixel ' +
            'corners. oracle: the truth itself.'],
        ['truth', 'traced from the exact polyhedron as given, not from a smooth surface imagined behind it.'],
        ['contour', 'a line where the surface turns away: one side empty, on an edge of two faces or more.'],
        ['boundary', 'one side empty, on an edge of one face.'],
        ['crease', 'both faces visible, deviating from flat by at least the crease angle (40° unless asked).'],
        ['intersection', 'where two triangles pierce each other. One that bends by less than the crease angle does ' +
            'not count, neither when it is drawn nor when it is missing, unless the run counts all of them; its ' +
            'recall is told apart, as inters. < crease.'],
        ['seam', 'both faces visible and flatter than a crease, but of two objects.'],
        ['does not count', 'pixels at the frame, places where the true lines are too dense to tell apart, and intersections ' +
            'below the crease angle.'],
        ...CAUSES.map(cause => [cause.name.replace(/_/g, ' '), cause.text + '.']),
        ['causes', 'come from the exact truth at pixel centres. A false pixel is judged by the 3 × 3 pixels around ' +
            'it. For a missing pixel of a method that declares its code, the code is computed from the depth and ' +
            'normals where a stencil sees the line; the method’s image is not looked at.'],
        ['unmatched', 'pixels that one-to-one matching leaves over beside a line that was found: the line is ' +
            'doubled, frayed or shortened.'],
    ];
}

// ---- Provenance ---------------------------------------------------------------------------

/// Libraries whose versions rows name.
const ABOUT_LIBRARIES = ['embree', 'openimageio', 'onetbb', 'highway', 'fmt', 'glm'];

/// What the run folder says of itself: how it was made, by which build, on which machine.
function aboutProvenance(run) {
    const {record} = run;
    const row = run.table('rows.csv').lines[0] || {};
    const dirty = row.dirty === true || row.dirty === 'true' ? ' with changes on top' : '';
    const libraries = ABOUT_LIBRARIES.filter(name => row[name]).map(name => `${name} ${row[name]}`).join(', ');
    const entries = [
        ['run', record.name ? `${record.name} (${record.kind})` : run.label],
        ['command', record.command ? element('code', {}, record.command) : null],
        ['state', `${record.state}, ${record.blocks_done} of ${record.blocks} parts, ${count(record.cells, 'cell')}`],
        ['took', record.work_s > 0 ? `${formatNumber(record.work_s)} s of work` : null],
        ['times', record.times === false ? 'left out of this run' : null],
        ['version', row.version ? `${row.version}, commit ${row.commit}${dirty}` : record.build],
        ['compiler', row.compiler], ['flags', row.flags], ['libraries', libraries],
        ['processor', row.cpu], ['instructions', row.simd],
        ['creases', row.creases === 'file' ? 'edges that the model\'s file marks' : null],
        ['crease angle', row.crease_deg === undefined ? null : `${row.crease_deg}°`],
        ['intersections', row.intersections === 'all' ? 'all count' : 'those that bend at least by the crease angle count'],
        ['image size', row.width ? `${row.width} × ${row.height} px` : null],
        ['threads', row.threads], ['seed', row.seed],
        ['identity', record.identity ? element('code', {}, record.identity) : null],
    ].filter(([, value]) => value !== null && value !== undefined && value !== '');
    const list = element('dl', {class: 'terms'},
        entries.map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value))));
    const asked = record.asked ? element('details', {'data-name': 'asked'},
        element('summary', {}, 'Everything that was asked, as a file of inkbench run'),
                                         element('pre', {class: 'asked', tabindex: '0', role: 'group', 'aria-label': 'What was asked'}, record.asked)) : null;
    return element('div', {}, list, asked);
}

/// Every parameter of a method, and where the method comes from.
function aboutParameters(root, view) {
    const lines = view.run.table('methods.csv').lines;
    const methods = [...view.run.methods.values()].filter(info => Object.keys(info.params).length > 0);
    if (methods.length === 0) return;
    const info = methods.find(m => m.name === state.get('about.method')) || methods.find(m => !m.isBaseline) ||
        methods[0];
    const line = lines.find(l => l.method === info.name) || {};
    root.append(element('h3', {}, 'Parameters'), element('div', {class: 'tools'},
        chooser('Method', methods.map(m => [m.name, m.name]), info.name,
        name => state.set({'about.method': name}))));
    if (line.source) root.append(element('p', {class: 'soft'}, `Source: ${line.source}`));
    const tunable = aboutTunables(line.tunables);
    makeTable(root, {
        name: 'about-parameters', lines: Object.entries(info.params)
            .map(([name, value]) => ({name, value, range: tunable.get(name) || ''})),
        columns: [
            {key: 'parameter', title: 'parameter', isText: true, value: l => l.name, node: l => element('code', {},
                l.name)},
            {key: 'value', title: 'value in this run', isText: true, value: l => l.value},
            {key: 'tuned', title: 'tuned between', isText: true, value: l => l.range},
        ],
    });
}

/// "a:1..5;b:x|y" as a map from name to words.
function aboutTunables(text) {
    const known = new Map();
    for (const part of (text || '').split(';')) {
        const at = part.indexOf(':');
        if (at > 0) known.set(part.slice(0, at), part.slice(at + 1).replace('..', ' and ').replace(/\|/g, ', '));
    }
    return known;
}

/// What the columns of the run's tables mean.
function aboutColumns(root, run) {
    const docs = window.columnDocs || {};
    const tables = Object.keys(run.tables).filter(name => docs[name]);
    if (tables.length === 0) return;
    const chosen = tables.includes(state.get('about.table')) ? state.get('about.table') : tables[0];
    root.append(element('h3', {}, 'Columns of the tables in the run folder'), element('div', {class: 'tools'},
        chooser('Table', tables.map(name => [name, name]), chosen, name => state.set({'about.table': name}))));
    makeTable(root, {
        name: 'about-columns', most: 40,
            lines: run.table(chosen).names.map(name => ({name, ...(docs[chosen][name] || {unit: '', doc: ''})})),
        columns: [
            {key: 'column', title: 'column', isText: true, value: line => line.name, node: line => element('code',
                {}, line.name)},
            {key: 'unit', title: 'unit', isText: true, value: line => line.unit},
            {key: 'doc', title: 'meaning', isText: true, value: line => line.doc},
        ],
    });
}
