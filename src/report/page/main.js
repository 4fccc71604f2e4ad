// Puts the page together. Sections stand in the order in which their files were read; each draws
// what the filters leave when it comes near the window, and again when a choice changes.

/// Main parts that have a link of their own; with those to the rest and to the words there are at most eight.
const MOST_LINKS = 6;

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

function buildSections(main) {
    const view = cachedView();
    const watcher = new IntersectionObserver(entries => {
        for (const entry of entries) {
            const section = sections.find(s => s.node === entry.target);
            section.isNear = entry.isIntersecting;
            if (section.isNear && section.isStale && isOpen(section)) drawSection(section);
        }
    }, {rootMargin: '600px'});
    // A run of one study alone has no main part: all it has is what the reader came for.
    const isAlone = !runs.some(run => run.rows.length);
    for (const section of sections) {
        section.isAlone = isAlone;
        section.body = element('div', {class: 'section-body'});
        const intro = typeof section.intro === 'function' ? section.intro(view) : section.intro;
        const words = intro ? element('p', {class: 'soft'}, intro) : null;
        section.node = element('section', {id: section.id}, section.isMain
            ? [element('h2', {}, section.title), words, section.body].filter(Boolean) : foldedPart(section, words));
        section.isStale = true;
        main.append(section.node);
        watcher.observe(section.node);
    }
    showParts();
}

/// Which of the folded parts are open stands in the address.
function foldedPart(section, words) {
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

/// Goes to a part as a link does.
function goTo(section) {
    if (section.fold) section.fold.open = true;
    section.node.scrollIntoView({behavior: 'smooth'});
}

/// Hides the parts that have nothing to say, and links the others.
function showParts() {
    const view = cachedView();
    const there = sections.filter(section => !section.isThere || section.isThere(view));
    for (const section of sections) section.node.hidden = !there.includes(section);
    const words = sections.find(section => section.id === 'about');
    const main = there.filter(section => section !== words && (section.isMain || section.isAlone)).slice(0, MOST_LINKS);
    const rest = there.find(section => section !== words && !main.includes(section));
    const link = (section, text) => element('a', {href: `#${section.id}`, onclick: event => {
        event.preventDefault();
        goTo(section);
    }}, text);
    document.querySelector('nav .wrap').replaceChildren(...main.map(section => link(section, section.title)),
        ...(rest ? [link(rest, 'In detail')] : []), link(words, words.title));
}

function redraw(changed) {
    const isFilter = changed.some(name => name === 'run' || FILTERS.includes(name));
    if (changed.includes('theme')) applyTheme();
    if (isFilter) {
        viewCache = null;
        showParts();
        drawHead();
    }
    const filters = document.getElementById('filters');
    redrawInPlace(filters, () => drawFilters(filters, cachedView()));
    for (const section of sections) {
        const uses = section.uses || [];
        const isHit = isFilter || changed.some(name => uses.includes(name) || uses.some(u => u.endsWith('*') && name.startsWith(u.slice(0, -1))));
        if (!isHit) continue;
        section.isStale = true;
        if (section.isNear && isOpen(section)) drawSection(section);
    }
}

function drawHead() {
    const head = document.querySelector('header .wrap');
    redrawInPlace(head, () => drawHeader(head, cachedView()));
}

function applyTheme() {
    const theme = state.get('theme');
    const isDark = theme === 'dark' || (theme === 'auto' && matchMedia('(prefers-color-scheme: dark)').matches);
    document.documentElement.className = isDark ? 'dark-theme' : 'light-theme';
}

async function start() {
    await inflateTables(PACKED.runs);
    runs = PACKED.runs.map((run, index) => new Run(run, index));
    viewImages = new ViewImages(JSON.parse(document.getElementById('images').textContent));
    window.columnDocs = PACKED.columns;
    applyTheme();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', applyTheme);
    drawHead();
    drawFilters(document.getElementById('filters'), cachedView());
    buildSections(document.querySelector('main'));
    state.onChange(redraw);
    window.addEventListener('hashchange', () => {
        state.readAddress();
        openFolds();
    });
    window.addEventListener('beforeprint', openForPaper);
    window.addEventListener('afterprint', closeAfterPaper);
    document.querySelector('footer').append(`Made by inkbench ${PACKED.version}. ${viewImages.placeWords()} `,
        element('button', {type: 'button', class: 'quiet', onclick: printAll}, 'Print with all pictures'));
    document.documentElement.dataset.ready = '1';
}

start();
