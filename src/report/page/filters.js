// The bar on top that all parts of the page obey, and what it leaves of a run.

state.define('run', 0);
state.define('families', null);
state.define('methods', null);
state.define('scenes', null);
state.define('split', 'all');
state.define('scene_kind', 'all');
state.define('projection', 'all');
// What the run was asked for, until the reader asks for something else.
state.define('measure', PACKED.runs[0].record.measure);
state.define('budget', PACKED.runs[0].record.budget_ms);
state.define('margin', PACKED.runs[0].record.f_margin);
state.define('theme', 'auto');

/// What a reader filters by, and Reset gives back.
const FILTERS = ['families', 'methods', 'scenes', 'split', 'scene_kind', 'projection', 'measure', 'budget', 'margin'];

/// What the page shows now: the rows that the filters leave, and what they say together.
function currentView() {
    const run = runs[state.get('run')] || runs[0];
    return viewOf(run);
}

/// Whether grey lines were scored: in all runs, so that these can be held against each other.
function hasInk() {
    return runs.every(run => run.rows.length === 0 || run.rows.some(row => isNumber(row.soft_f)));
}

/// The chosen measure; F where that is soft F and not every run has it.
function shownMeasure() {
    const measure = state.get('measure');
    return measure === 'soft_f' && !hasInk() ? 'f_2px' : measure;
}

function isSceneShown(row) {
    const scenes = state.get('scenes');
    const isOne = column => state.get(column) === 'all' || row[column] === state.get(column);
    return (!scenes || scenes.includes(row.scene)) && isOne('split') && isOne('scene_kind') && isOne('projection');
}

function isMethodChosen(info) {
    const methods = state.get('methods');
    const families = state.get('families');
    if (info.isBaseline) return true;
    return (!methods || methods.includes(info.name)) && (!families || families.includes(info.family));
}

function viewOf(run) {
    const measure = shownMeasure();
    const allRows = run.rows.filter(isSceneShown);
    const isMethodShown = name => isMethodChosen(run.methods.get(name));
    const rows = allRows.filter(row => isMethodShown(row.method));
    const hasAllScenes = !state.get('scenes') && state.get('split') === 'all' && state.get('scene_kind') === 'all' &&
        state.get('projection') === 'all';
    const summaries = [...groupBy(rows, row => row.method)].map(([name, ofMethod]) => {
        const made = summarise(run.methods.get(name), ofMethod, measure);
        return {...made, range: rangeOf(run, made, measure, hasAllScenes)};
    });
    const budget = state.get('budget');
    const isAffordable = s => !budget || (s.ms !== null && s.ms <= budget);
    const contestants = summaries.filter(s => !s.isBaseline && s.value !== null);
    const byValue = [...contestants].sort((a, b) => b.value - a.value);
    const ranked = byValue.filter(isAffordable);
    const answer = findAnswer(contestants, {margin: state.get('margin'), budget});
    let differences = null;
    const scenes = distinct(allRows, row => row.scene);
    return {
        run, measure, allRows, rows, summaries, contestants, ranked, isAffordable, isMethodShown, scenes,
        hasAllScenes, answer, best: answer.method, isWhole: isWhole(run),
        /// The paired difference of two methods, by name.
        differenceOf: (a, b) => {
            const table = differencesTable(run, measure);
            if (hasAllScenes && table.has('scenes')) return (differences ??= tabledDifferences(table))(a, b);
            const [ofA, ofB] = [a, b].map(name => contestants.find(s => s.method === name));
            return pairedDifference(ofA.rows, ofB.rows, measure);
        },
        views: distinct(allRows, row => `${row.scene}\n${row.view}`).length,
        methods: contestants.map(s => s.info),
        /// Lines of a side table of the run that the filters leave, joined with their rows.
        lines: name => run.joined(name).filter(
            line => isMethodShown(line.method) && isSceneShown(line)),
    };
}

/// What the page calls a part of the suite.
function splitTitle(split) {
    return {train: 'training', heldout: 'held-out', real: 'real models'}[split] ?? split;
}

function isFiltered() {
    return FILTERS.some(name => !state.isDefault(name));
}

/// Whether the page shows all of a run, asked as the run was: then the words of the run hold.
function isWhole({words, record}) {
    return words !== null && !isFiltered() && shownMeasure() === record.measure && state.get('budget') === record.budget_ms &&
        state.get('margin') === record.f_margin;
}

function drawFilters(root, view) {
    const {run} = view;
    const methods = [...run.methods.values()].filter(info => !info.isBaseline);
    const scenes = distinct(run.table('rows.csv').lines, row => row.scene);
    const families = distinct(methods, info => info.family);
    const classes = RECALL_GROUPS.filter(name => run.rows.some(row => row[`truth_px_${name}`] > 0));
    const splits = distinct(run.rows, row => row.split);
    const projections = distinct(run.rows, row => row.projection);
    const kinds = distinct(run.rows, row => row.scene_kind).filter(Boolean);
    const isOpen = root.querySelector('details.filters')?.open ?? innerWidth > 720;
    const steps = budgetSteps(view.contestants);

    const controls = element('div', {class: 'filter-row'},
        runs.length > 1 ? chooser('Run', runs.map((r, i) => [i, r.label]), run.index,
            index => state.set({run: Number(index)})) : null,
        families.length > 1 ? familyButtons(families) : null,
        methods.length > 1 ? picker('Methods', 'methods', methods.map(info => info.name)) : null,
        scenes.length > 1 ? picker('Scenes', 'scenes', scenes) : null,
        splits.length > 1 ? chooser('Split', [['all', 'all scenes'], ...splits.map(split => [split, splitTitle(split)])],
            state.get('split'), split => state.set({split})) : null,
        kinds.length > 1 ? chooser('Kind', [['all', 'all kinds'], ...kinds.map(one => [one, one])],
            state.get('scene_kind'), kind => state.set({scene_kind: kind})) : null,
        projections.length > 1 ? chooser('Projection', [['all', 'both projections'], ...projections.map(one => [one, one])],
            state.get('projection'), projection => state.set({projection})) : null,
        run.rows.length ? chooser('Measure', [
            ...(hasInk() ? [['soft_f', 'soft F']] : []),
            ['f_2px', 'F at 2 px'], ['f_1px', 'F at 1 px'], ['precision', 'precision'], ['recall', 'recall'],
            ...classes.map(name => [name, `recall: ${groupTitle(name)}`])], view.measure,
            measure => state.set({measure})) : null,
        steps.length ? budgetField(steps) : null,
        run.rows.length ? marginField() : null,
        element('button', {type: 'button', id: 'reset', 'aria-disabled': isFiltered() ? null : 'true', onclick: () => state.reset(FILTERS)}, 'Reset'),
        chooser('Theme', [['auto', 'system'], ['light', 'light'], ['dark', 'dark']], state.get('theme'),
            theme => state.set({theme})));
    root.replaceChildren(element('details', {class: 'filters', open: isOpen},
        element('summary', {}, isFiltered() ? 'Filters (changed)' : 'Filters'), controls));
}

function familyButtons(families) {
    const chosen = state.get('families') || families;
    return element('span', {class: 'choices', role: 'group', 'aria-label': 'Families of methods'},
        families.map(family => {
            const isOn = chosen.includes(family);
            const button = toggleButton(familyOf({family}).title, isOn, () => {
                const left = isOn ? chosen.filter(f => f !== family) : [...chosen, family];
                state.set({families: left.length === families.length || left.length === 0 ? null : left});
            });
            button.dataset.family = family;
            button.style.setProperty('--family', familyOf({family}).colour);
            button.classList.add('family');
            return button;
        }));
}

/// A list of names to tick; null means all of them.
function picker(title, name, all) {
    const chosen = state.get(name);
    const isOn = entry => !chosen || chosen.includes(entry);
    const choose = list => state.set({[name]: list.length === all.length ? null : list});
    return element('details', {class: 'picker', 'data-name': name},
        element('summary', {}, title, element('b', {}, chosen ? ` ${chosen.length} of ${all.length}` : ' all')),
        element('div', {class: 'picker-list'},
            element('div', {class: 'tools'},
                element('button', {type: 'button', onclick: () => choose(all)}, 'All'),
                element('button', {type: 'button', onclick: () => choose([])}, 'None')),
            all.map(entry => element('label', {}, element('input', {
                type: 'checkbox', value: entry, checked: isOn(entry),
                onchange: event => choose(all.filter(
                    other => (other === entry ? event.target.checked : isOn(other)))),
            }), ' ', entry))));
}

/// The times that a budget may have: each method's own, a little up to three digits, so that it stays
/// within; a step below all of them, where none is fast enough; 0, no budget. {ms, text} each.
function budgetSteps(contestants) {
    const timed = sortLines(contestants.filter(s => s.ms > 0), {value: s => s.ms}, false);
    if (!timed.length) return [];
    const digits = ms => 10 ** (Math.floor(Math.log10(ms)) - 2);
    const up = ms => Number((Math.ceil(ms / digits(ms)) * digits(ms)).toPrecision(3));
    const first = timed[0];
    return [{ms: Number((up(first.ms) - 2 * digits(first.ms)).toPrecision(3)),
             text: `none is faster than ${formatMs(first.ms)} ms (${first.method})`},
            ...[...groupBy(timed, s => up(s.ms))].map(([ms, same]) => ({ms, text: `${formatMs(ms)} ms (${same.map(s => s.method).join(', ')})`})),
            {ms: 0, text: 'none'}];
}

/// The time budget: methods that take longer are greyed, and the headline names the best within it.
function budgetField(steps) {
    const budget = state.get('budget');
    const last = steps.length - 1;
    const at = budget ? Math.max(0, d3.bisector(step => step.ms || Infinity).right(steps, budget) - 1) : last;
    const isStep = steps[at].ms === budget || at === 0;
    const words = element('b', {}, isStep ? steps[at].text : `${formatMs(budget)} ms`);
    return element('label', {class: 'field'}, element('span', {}, 'Time budget'),
        element('input', {
            type: 'range', id: 'budget', min: 0, max: last, value: at, 'aria-label': 'Time budget', 'aria-valuetext': words.textContent,
            oninput: event => { words.textContent = steps[event.target.value].text; },
            onchange: event => state.set({budget: steps[event.target.value].ms}),
        }), words);
}

/// How far below the best an answer may lie.
function marginField() {
    return element('label', {class: 'field', title: 'The answer is the cheapest method that lies at most so far below the best'},
        element('span', {}, 'Margin'),
        element('input', {
            type: 'number', id: 'margin', min: 0, max: 1, step: 'any', value: state.get('margin'), 'aria-label': 'Margin below the best',
            onchange: ({target}) => {
                if (!target.reportValidity()) target.value = state.get('margin');
                else if (target.value !== '') state.set({margin: Number(target.value)});
            },
        }));
}
