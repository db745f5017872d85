# SPDX-License-Identifier: Apache-2.0
"""A film on disk, and how a notebook shows it."""

import base64
import html
from dataclasses import dataclass
from pathlib import Path

_VIDEO = {".mp4": "video/mp4", ".mov": "video/mp4", ".webm": "video/webm"}
_PICTURE = {".gif": "image/gif", ".apng": "image/apng", ".png": "image/apng"}
_MOST_INLINE_BYTES = 32 << 20


@dataclass(frozen=True)
class Film:
    """A film that was made. In a notebook it plays in place, and its bytes are kept in the notebook."""

    path: Path
    size: tuple[int, int]  #: width and height in pixels
    frame_count: int
    duration: float  #: s

    def _repr_html_(self) -> str:
        place = html.escape(str(self.path))
        if "{frame" in self.path.name:
            return f"<p>{self.frame_count} pictures: {place}</p>"
        if not self.path.is_file():
            return f"<p>The film {place} is no longer there: it was moved or removed.</p>"
        source = self._source()
        suffix = self.path.suffix.lower()
        width = f'style="max-width: 100%; width: {min(self.size[0], 960)}px"'
        if suffix in _VIDEO:
            return f'<video src="{source}" controls loop {width}></video>'
        if suffix in _PICTURE:
            return f'<img src="{source}" {width}>'
        return place

    def _source(self) -> str:
        """The film itself; of a long one its place."""
        kind = (_VIDEO | _PICTURE).get(self.path.suffix.lower())
        if kind is None or self.path.stat().st_size > _MOST_INLINE_BYTES:
            return html.escape(str(self.path), quote=True)
        return f"data:{kind};base64,{base64.b64encode(self.path.read_bytes()).decode()}"
