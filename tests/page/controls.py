"""Finds the controls of the page by what a reader sees of them, and works one as a reader does."""

# Controls are drawn anew by each choice, so a name stands for one. What saves a file is no choice.
CONTROLS = """
window.controlsBelow = selector => {
    const nameOf = node => node.type === 'checkbox' ? node.value : node.id || node.getAttribute('aria-label')
        || node.textContent.replace(/[▾▴]/g, '').trim();
    const kindOf = node => node.matches('thead button') ? 'head' : node.matches('input') ? node.type
        : node.matches('.side-line, .thumb-button') ? 'picture' : node.tagName.toLowerCase();
    const seen = new Map();
    return [...document.querySelectorAll(`${selector} :is(button, select, input)`)]
        .filter(node => node.checkVisibility() && !/CSV|^SVG$/.test(node.textContent)).map(node => {
        const name = `${kindOf(node)} ${node.parentElement.getAttribute('aria-label') || ''} ${nameOf(node)}`;
        seen.set(name, (seen.get(name) || 0) + 1);
        return {node, kind: kindOf(node), name: `${name} ${seen.get(name)}`};
    });
};
return controlsBelow(arguments[0]).map(({node, kind, name}) => ({kind, name, choices:
    kind === 'select' ? [...node.options].filter(option => !option.selected).map(option => option.value)
    : kind === 'range' ? [node.min, String(Math.round(Number(node.max) / 3)), node.max]
    : kind === 'search' ? ['cube', ''] : kind === 'color' ? ['#0044cc'] : [null]}));
"""

# Works one control; false if it is not there, as a choice before may have taken it away.
WORK = """
const [selector, name, choice] = arguments;
const control = controlsBelow(selector).find(c => c.name === name);
if (!control) return false;
control.node.focus({preventScroll: true});
if (choice === null) control.node.click();
else {
    control.node.value = choice;
    for (const type of ['input', 'change']) control.node.dispatchEvent(new Event(type, {bubbles: true}));
}
return true;
"""


def controls(browser, root):
    """What stands below `root` and is seen: [{kind, name, choices}]; `head` sorts a table, `picture`
    opens one in the viewer."""
    return browser.execute_script(CONTROLS, root)


def work(browser, root, control, choice=None):
    """Makes a choice at one of controls(); false if it is there no more."""
    return browser.execute_script(WORK, root, control["name"], choice)
