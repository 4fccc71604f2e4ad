"""Figures as files: each whole or not at all, the same bytes for the same rows."""

import io
import os
import tempfile
from pathlib import Path

from paper.runs import BadInput

FORMATS = ["pdf", "svg", "png"]
# Without dates and version numbers, so that the same rows give the same bytes.
_METADATA = {"pdf": {"CreationDate": None, "Creator": None, "Producer": None},
             "svg": {"Date": None, "Creator": None}, "png": {"Software": None}}


PNG_DPI = 400


def encode(figure, kind, dpi=PNG_DPI):
    """The figure as bytes of a PDF, an SVG or a PNG (at `dpi`), exactly as wide as it was made."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format=kind, metadata=_METADATA[kind], dpi=dpi if kind == "png" else 72)
    return buffer.getvalue()


def write_whole(path, content):
    """Writes bytes or text so that the file is there whole or not at all; BadInput if it fails."""
    path = Path(path)
    content = content.encode("utf-8") if isinstance(content, str) else content
    name = None
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=path.name, suffix=".part",
                                         delete=False) as file:
            name = file.name
            file.write(content)
        os.chmod(name, 0o666 & ~_umask())
        os.replace(name, path)
    except OSError as error:
        if name is not None and os.path.exists(name):
            os.unlink(name)
        raise BadInput(path, f"it cannot be written ({error.strerror})",
                       "a folder that can be written, with room") from error


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
