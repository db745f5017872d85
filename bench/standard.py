# SPDX-License-Identifier: Apache-2.0
"""Renders of the standard scene, and the other commands of the program that are measured."""
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
SCENE = HERE / 'standard.toml'
SPAN_S = 20  # of motion, over which the frames are spread, whatever their number
FPS = 30


class Program:
    """The commands of one built program, as functions of the number of frames."""

    def __init__(self, path):
        self.path = path

    def film(self, *options, output='film.mp4'):
        """H.264 at the scene's rate factor: the number of frames changes how far apart they are, not what they show."""
        return lambda frames: self._render(frames, '-o', output, *options)

    def pictures(self, folder='.'):
        return lambda frames: self._render(frames, '-o', f'{folder}/frame_{{frame:05}}.png')

    def still(self):
        return lambda _: [self.path, 'still', SCENE, '-o', 'still.png', '--quiet', '--stats']

    def excerpt(self, scene, first):
        """Frames of another scene's film, from the `first` one on."""
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
        """Of two that `pictures(folder)` makes, which differ, with limits that let any difference pass."""
        anything = [word for limit, most in {'max': '255', 'pixels': '100%', 'flip-mean': '1', 'flip-max': '0.9999'}.items()
                    for word in (f'--{limit}', f'0-{most}')]
        return lambda _: [self.path, 'diff', folder / 'frame_00000.png', folder / 'frame_00001.png', *anything]

    def _render(self, frames, *options):
        duration_s = frames / FPS
        # The range besides: 100 / 30 s times 30 frames/s is 101 frames.
        return [self.path, 'render', SCENE, '-D', f'time.duration={duration_s!r}',
                '-D', f'time.speed={SPAN_S / duration_s!r}', '--frames', f'0-{frames - 1}',
                '--quiet', '--stats', *options]
