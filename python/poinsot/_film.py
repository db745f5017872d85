# SPDX-License-Identifier: Apache-2.0
"""A film on disk, with its display in a notebook."""

import base64
import html
from dataclasses import dataclass
from pathlib import Path

_VIDEO = {".mp4": "video/mp4", ".mov": "video/mp4", ".webm": "video/webm"}
_PICTURE = {".gif": "image/gif", ".apng": "image/apng", ".png": "image/apng"}
_MOST_INLINE_BYTES = 32 << 20


@dataclass(frozen=True)
class Film:
    """A finished film. In a notebook, the film plays in its cell, and the notebook stores its bytes."""

    path: Path
    size: tuple[int, int]  #: width and height in pixels
    frame_count: int
    duration: float  #: in s

    def _repr_html_(self) -> str:
        place = html.escape(str(self.path))
        if "{frame" in self.path.name:
            return f"<p>{self.frame_count} pictures: {place}</p>"
        if not self.path.is_file():
            return f"<p>The film {place} no longer exists: it was moved or removed.</p>"
        source = self._source()
        suffix = self.path.suffix.lower()
        width = f'style="max-width: 100%; width: {min(self.size[0], 960)}px"'
        if suffix in _VIDEO:
            return f'<video src="{source}" controls loop {width}></video>'
        if suffix in _PICTURE:
            return f'<img src="{source}" {width}>'
        return place

    def _source(self) -> str:
        """Returns the film as a data URL, or its path if the film is large."""
        kind = (_VIDEO | _PICTURE).get(self.path.suffix.lower())
        if kind is None or self.path.stat().st_size > _MOST_INLINE_BYTES:
            return html.escape(str(self.path), quote=True)
        return f"data:{kind};base64,{base64.b64encode(self.path.read_bytes()).decode()}"
