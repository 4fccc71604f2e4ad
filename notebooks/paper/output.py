"""Figures as files: each whole or not at all, the same bytes for the same rows."""

import contextlib
import io

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
    part = path.with_name(path.name + ".part")
    try:
        part.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
        part.replace(path)
    except OSError as error:
        with contextlib.suppress(OSError):
            part.unlink()
        raise BadInput(path, f"it cannot be written ({error.strerror})",
                       "a folder that can be written, with room") from error
