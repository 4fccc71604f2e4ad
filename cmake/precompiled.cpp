// Nothing: a target needs a source, and what this one is for are the headers compiled before it.
