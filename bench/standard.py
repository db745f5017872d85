# SPDX-License-Identifier: Apache-2.0
"""Commands of the program that are measured: renders of the standard scene, and others."""
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
SCENE = HERE / 'standard.toml'
SPAN_S = 20  # seconds of motion that the frames cover, for any number of frames
FPS = 30


class Program:
    """The commands of one built program, as functions of the number of frames."""

    def __init__(self, path):
        self.path = path

    def film(self, *options, output='film.mp4'):
        """H.264 at the scene's rate factor. More frames cover the same motion in smaller steps."""
        return lambda frames: self._render(frames, '-o', output, *options)

    def pictures(self, folder='.'):
        return lambda frames: self._render(frames, '-o', f'{folder}/frame_{{frame:05}}.png')

    def still(self):
        return lambda _: [self.path, 'still', SCENE, '-o', 'still.png', '--quiet', '--stats']

    def excerpt(self, scene, first):
        """Frames of another scene's film, beginning with frame `first`."""
        return lambda frames: [self.path, 'render', scene, '--frames', f'{first}-{first + frames - 1}',
                               '-o', 'film.mp4', '--quiet', '--stats']

    def trajectory(self):
        return lambda rows: [self.path, 'trajectory', SCENE, '--rate', f'{max(1, rows - 1) / SPAN_S}',
                             '-o', 'rows.csv']

    def help(self):
        return lambda _: [self.path, '--help']

    def check(self, scene):
        return lambda _: [self.path, 'check', scene]

    def diff(self, folder):
        """Compares the first two pictures that `pictures(folder)` makes, with limits that accept any difference."""
        anything = [word for limit, most in {'max': '255', 'pixels': '100%', 'flip-mean': '1', 'flip-max': '0.9999'}.items()
                    for word in (f'--{limit}', f'0-{most}')]
        return lambda _: [self.path, 'diff', folder / 'frame_00000.png', folder / 'frame_00001.png', *anything]

    def _render(self, frames, *options):
        duration_s = frames / FPS
        # With --frames, because a film of 100 / 30 s at 30 frames/s has 101 frames.
        return [self.path, 'render', SCENE, '-D', f'time.duration={duration_s!r}',
                '-D', f'time.speed={SPAN_S / duration_s!r}', '--frames', f'0-{frames - 1}',
                '--quiet', '--stats', *options]
