// Puts the page together. Sections stand in the order in which their files were read; each draws
// what the filters leave when it comes near the window, and again when a choice changes.

const FILTERS = ['run', 'families', 'methods', 'scenes', 'split', 'measure', 'budget', 'margin'];

function drawSection(section) {
    section.isStale = false;
    const view = cachedView();
    const isThere = !section.isThere || section.isThere(view);
    redrawInPlace(section.body, () => {
        section.body.replaceChildren();
        if (isThere) section.draw(section.body, view);
    });
}

state.define('open', []);

let viewCache = null;
function cachedView() {
    if (!viewCache) viewCache = currentView();
    return viewCache;
}

function buildSections(main, nav) {
    const view = cachedView();
    const watcher = new IntersectionObserver(entries => {
        for (const entry of entries) {
            const section = sections.find(s => s.node === entry.target);
            section.isNear = entry.isIntersecting;
            if (section.isNear && section.isStale && isOpen(section)) drawSection(section);
        }
    }, {rootMargin: '600px'});
    for (const section of sections) {
        section.body = element('div', {class: 'section-body'});
        const intro = typeof section.intro === 'function' ? section.intro(view) : section.intro;
        const words = intro ? element('p', {class: 'soft'}, intro) : null;
        section.node = element('section', {id: section.id}, section.isFolded
            ? foldedPart(section, words)
            : [element('h2', {}, section.title), words, section.body]);
        section.isStale = true;
        section.node.hidden = Boolean(section.isThere && !section.isThere(view));
        main.append(section.node);
        watcher.observe(section.node);
        nav.append(element('a', {href: `#${section.id}`, 'data-section': section.id, onclick: event => {
            event.preventDefault();
            if (section.fold) section.fold.open = true;
            section.node.scrollIntoView({behavior: 'smooth'});
        }}, section.title));
    }
    showLinks();
}

/// A part that few need starts closed; which ones are open stands in the address.
function foldedPart(section, words) {
    // A run of one study alone has no part before it: it is what the reader came for.
    section.isAlone = !runs.some(run => run.rows.length);
    section.fold = element('details', {class: 'fold', open: section.isAlone || state.get('open').includes(section.id)},
        element('summary', {}, element('h2', {}, section.title)), words, section.body);
    section.fold.addEventListener('toggle', () => {
        const others = state.get('open').filter(id => id !== section.id);
        if (!section.isAlone) state.set({open: section.fold.open ? [...others, section.id] : others});
        if (section.fold.open && section.isStale) drawSection(section);
    });
    return section.fold;
}

/// Parts are open as the address says that the reader typed.
function openFolds() {
    for (const {fold, id, isAlone} of sections) if (fold && !isAlone) fold.open = state.get('open').includes(id);
}

function isOpen(section) {
    return !section.fold || section.fold.open;
}

function showLinks() {
    const view = cachedView();
    for (const section of sections) {
        const isThere = !section.isThere || section.isThere(view);
        section.node.hidden = !isThere;
        const link = document.querySelector(`nav a[data-section="${section.id}"]`);
        link.hidden = !isThere;
    }
}

function redraw(changed) {
    const isFilter = changed.some(name => FILTERS.includes(name));
    if (changed.includes('theme')) applyTheme();
    if (isFilter) {
        viewCache = null;
        showLinks();
        drawHeader(document.querySelector('header .wrap'), cachedView());
    }
    const filters = document.getElementById('filters');
    redrawInPlace(filters, () => drawFilters(filters));
    for (const section of sections) {
        const uses = section.uses || [];
        const isHit = isFilter || changed.some(name => uses.includes(name) || uses.some(u => u.endsWith('*') && name.startsWith(u.slice(0, -1))));
        if (!isHit) continue;
        section.isStale = true;
        if (section.isNear && isOpen(section)) drawSection(section);
    }
}

function applyTheme() {
    const theme = state.get('theme');
    const isDark = theme === 'dark' || (theme === 'auto' && matchMedia('(prefers-color-scheme: dark)').matches);
    document.documentElement.className = isDark ? 'dark-theme' : 'light-theme';
}

function start() {
    runs = PACKED.runs.map((run, index) => new Run(run, index));
    viewImages = new ViewImages(JSON.parse(document.getElementById('images').textContent));
    window.columnDocs = PACKED.columns;
    applyTheme();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', applyTheme);
    drawHeader(document.querySelector('header .wrap'), cachedView());
    drawFilters(document.getElementById('filters'));
    buildSections(document.querySelector('main'), document.querySelector('nav .wrap'));
    state.onChange(redraw);
    window.addEventListener('hashchange', () => {
        state.readAddress();
        openFolds();
    });
    document.querySelector('footer').textContent =
        `Made by inkbench ${PACKED.version}. This page needs no other file and no network.`;
    document.documentElement.dataset.ready = '1';
}

start();
