// The card that floats beside the pointer: the image behind a point or a table cell. A click pins it
// and blinks the truth over it; from there one more goes to the viewer.

const card = {
    node: null,
    target: null,
    rows: [],
    at: 0,
    isPinned: false,
    blinks: null,
    isTruthShown: false,
};

/// Lets `node` answer the pointer with the images of `rows` (of one run), the worst first. `facts`
/// are lines of text that the card shows below.
function answerPointer(node, rows, facts = []) {
    const target = node.node ? node.node() : node;
    target.classList.add('answers');
    target.setAttribute('tabindex', '0');
    if (target instanceof SVGElement) {
        target.setAttribute('role', 'button');
        const name = rows[0].method;
        target.setAttribute('aria-label', (facts[0].startsWith(name) ? facts : [name, ...facts]).join(', '));
    }
    answerHover(target, rows, facts);
    const pin = event => {
        event.stopPropagation();
        event.preventDefault(); // or the key presses what has the focus next: the card's own button
        const box = target.getBoundingClientRect();
        showCard(target, rows, facts, {clientX: event.clientX || box.right, clientY: event.clientY || box.top});
        pinCard();
    };
    target.addEventListener('click', pin);
    target.addEventListener('keydown', event => {
        if (event.key === 'Enter' || event.key === ' ') pin(event);
    });
}

/// Shows the card of `rows` while the pointer is on `target`.
function answerHover(target, rows, facts) {
    target.addEventListener('pointerenter', event => {
        if (!card.isPinned && event.pointerType !== 'touch') showCard(target, rows, facts, event);
    });
    target.addEventListener('pointermove', event => {
        if (!card.isPinned && card.node) moveCard(event.clientX, event.clientY);
    });
    target.addEventListener('pointerleave', () => {
        if (!card.isPinned) hideCard();
    });
}

/// Rows with most wrong pixels first; those of which there are images before those of which there
/// are none.
function sortedByErrors(rows) {
    const wrong = row => (row.false_positives || 0) + (row.false_negatives || 0);
    const hasImage = row => viewImages.has(runOf(row), row.scene, row.view, row.method);
    return [...rows].sort((a, b) => hasImage(b) - hasImage(a) || wrong(b) - wrong(a));
}

function runOf(row) {
    return runs[row.run ?? state.get('run')] || runs[0];
}

/// Shows the card of `rows`, the worst first; unless it is pinned, as long as `target` stands on the page.
function showCard(target, rows, facts, {clientX, clientY}) {
    card.target = target;
    whenGone(target, hideLostCard);
    card.rows = sortedByErrors(rows);
    card.facts = facts;
    card.at = 0;
    if (!card.node) {
        card.node = element('div', {class: 'card', role: 'dialog', 'aria-label': 'Image of a view'});
        document.body.append(card.node);
        document.addEventListener('click', event => {
            // A button of the card is gone from it when it has drawn the next view.
            if (card.isPinned && !event.composedPath().includes(card.node)) hideCard();
        });
        document.addEventListener('keydown', event => {
            if (event.key === 'Escape') hideCard();
        });
    }
    card.node.hidden = false;
    fillCard();
    moveCard(clientX, clientY);
}

function hideCard() {
    if (!card.node) return;
    const isHeld = card.node.contains(document.activeElement);
    card.node.hidden = true;
    card.isPinned = false;
    if (isHeld && card.target.isConnected) card.target.focus({preventScroll: true});
    card.node.classList.remove('pinned');
    clearInterval(card.blinks);
    card.isTruthShown = false;
}

function hideLostCard() {
    if (!card.isPinned && !card.target.isConnected) hideCard();
}

function pinCard() {
    card.isPinned = true;
    card.node.classList.add('pinned');
    clearInterval(card.blinks);
    card.isTruthShown = false;
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
        card.blinks = setInterval(() => {
            card.isTruthShown = !card.isTruthShown;
            drawCardImage();
        }, 700);
    }
    fillCard();
    card.node.querySelector('button').focus({preventScroll: true});
    const box = card.node.getBoundingClientRect();
    moveCard(box.left, box.top, 0);
}

function moveCard(x, y, gap = 16) {
    const width = card.node.offsetWidth;
    const height = card.node.offsetHeight;
    const left = x + gap + width > innerWidth ? x - gap - width : x + gap;
    card.node.style.left = `${Math.max(6, Math.min(left, innerWidth - width - 6))}px`;
    card.node.style.top = `${Math.max(6, Math.min(y + gap, innerHeight - height - 6))}px`;
}

function cardWidth_px() {
    return card.isPinned ? Math.min(680, innerWidth - 40) : Math.min(340, innerWidth - 40);
}

function fillCard() {
    redrawInPlace(card.node, drawCard);
}

/// "Worst of 24 views", or of how many of them there are images to know it by.
function worstWords() {
    const known = card.rows.filter(row => viewImages.has(runOf(row), row.scene, row.view, row.method)).length;
    const all = count(card.rows.length, 'view');
    if (known === 0) return `No image of its ${all}.`;
    return known === card.rows.length ? `Worst of ${all}.` : `Worst of the ${known} of ${all} with an image.`;
}

function drawCard() {
    const row = card.rows[card.at];
    const many = card.rows.length > 1;
    card.canvas = element('canvas', {class: 'picture'});
    card.words = element('p', {class: 'note'});
    const step = by => () => {
        card.at = (card.at + by + card.rows.length) % card.rows.length;
        fillCard();
    };
    const open = () => {
        hideCard();
        openInViewer({scene: row.scene, view: row.view, right: row.method, run: runOf(row).index});
    };
    card.node.replaceChildren(
        element('div', {class: 'card-head'},
            element('strong', {}, row ? `${row.method} · ${row.scene} · ${row.view}` : ''),
            card.isPinned ? element('button', {type: 'button', onclick: hideCard, 'aria-label': 'Close'}, '×') : null),
        card.canvas,
        card.words,
        row && isScored(row) ? element('p', {},
            `F ${formatShare(row.f_2px)} · missing ${row.false_negatives ?? NOTHING} px · false ` +
            `${row.false_positives ?? NOTHING} px` +
            (row.draw_ns ? ` · ${formatMs(row.draw_ns * 1e-6)} ms` : '')) : element('p', {}, row ? row.status : ''),
        ...card.facts.map(fact => element('p', {}, fact)),
        card.isPinned ? element('div', {class: 'tools'},
            many ? element('button', {type: 'button', onclick: step(-1)}, '‹ worse') : null,
            many ? element('span', {class: 'note'}, `${card.at + 1} of ${count(card.rows.length, 'view')}`) : null,
            many ? element('button', {type: 'button', onclick: step(1)}, 'better ›') : null,
            element('button', {type: 'button', class: 'main', onclick: open}, 'Open in the viewer'))
            : element('p', {class: 'note'}, many
                ? `${worstWords()} A click blinks the truth over it.`
                : 'A click blinks the truth over it.'));
    drawCardImage();
}

async function drawCardImage() {
    const row = card.rows[card.at];
    if (!row) return;
    const canvas = card.canvas;
    const what = card.isTruthShown ? 'truth' : row.method;
    const isDrawn = await drawThumb(canvas, runOf(row), row.scene, row.view, what, cardWidth_px());
    if (!canvas.isConnected) return; // another row's picture took its place
    canvas.hidden = !isDrawn;
    // The image may have made the card too tall for where it was.
    const box = card.node.getBoundingClientRect();
    if (box.bottom > innerHeight) moveCard(box.left, box.top, 0);
    card.words.textContent = !isDrawn
        ? viewImages.missingWords()
        : card.isPinned ? (what === 'truth' ? 'the truth' : 'the method, errors in colour') : '';
}
