# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench --peers`: measures other programs and the encoder alone, in turn with this program."""
import re

from job import Job, run_all
from measurement import measure
from standard import FPS, HERE
from table import mebibytes, milliseconds, ratio, seconds, table

PYTHON = '/usr/bin/python3'  # Debian's Python, which has Debian's VTK and Matplotlib
WIDTH, HEIGHT = 1920, 1080
FILM, PICTURES, FEW = 300, 60, 60  # frames; FEW for Matplotlib, whose frames all take equally long
FFMPEG = ['ffmpeg', '-nostdin', '-y', '-loglevel', 'error']
AS_OTHERS_ASK = ['-c:v', 'libx264', '-crf', '18', '-preset', 'medium', '-pix_fmt', 'yuv420p']


def measured(options, program, folder):
    """Returns tables and results."""
    frames, pictures, few = (2, 2, 2) if options.quick else (FILM, PICTURES, FEW)
    rgb, yuv = raw_frames(program, frames, folder)
    films = [
        Job('poinsot', 'poinsot', frames, program.film()),
        Job('RGB to x264', 'x264 alone, from RGB', frames, encoder(rgb, 'rgb24')),
        Job('YUV to x264', 'x264 alone, from YUV', frames, encoder(yuv, 'yuv420p')),
        Job('VTK', 'VTK, 4x MSAA', frames, vtk('film.mp4', 'msaablend')),
        Job('VTK, peeling', 'VTK, depth peeling, FXAA', frames, vtk('film.mp4', 'peel')),
        Job('Matplotlib', 'Matplotlib', few, matplotlib()),
    ]
    sequences = [
        Job('poinsot, PNG', 'poinsot', pictures, program.pictures()),
        Job('VTK, PNG', 'VTK, 4x MSAA', pictures, vtk('.', 'msaablend')),
        Job('VTK, peeling, PNG', 'VTK, depth peeling, FXAA', pictures, vtk('.', 'peel')),
    ]
    results = run_all(films + sequences, options.runs, warm_up=not options.quick)
    film_results, sequence_results = results[:len(films)], results[len(films):]
    return [against('film (J1)', film_results), beside_its_encoder(film_results[0]),
            film_worths(program, frames, folder), against('PNG (J2)', sequence_results)], results


def raw_frames(program, frames, folder):
    """Writes the unencoded pixels of the film to files, as RGB and as YUV, which the system keeps in memory."""
    measure(program.pictures(folder)(frames))
    rgb, yuv = folder / 'film.rgb', folder / 'film.yuv'
    pictures = [*FFMPEG, '-i', folder / 'frame_%05d.png', '-f', 'rawvideo', '-pix_fmt']
    measure([*pictures, 'rgb24', rgb])
    measure([*pictures, 'yuv420p', yuv])
    return rgb, yuv


def encoder(raw, pixels):
    """Returns a job's command: ffmpeg encodes raw frames on all cores, with preset medium and rate factor 18."""
    return lambda frames: [*FFMPEG, '-f', 'rawvideo', '-pix_fmt', pixels, '-s', f'{WIDTH}x{HEIGHT}', '-r', FPS,
                           '-i', raw, '-frames:v', frames, *AS_OTHERS_ASK, 'film.mp4']


def film_worths(program, frames, folder):
    """Returns a table of size and error of films of the same frames: a film that is faster to make may be worse."""
    exact, ours, theirs = (folder / name for name in ['exact.mp4', 'poinsot.mp4', 'x264.mp4'])
    measure(program.film('-D', 'output.crf=0', output=exact)(frames))
    measure(program.film(output=ours)(frames))
    measure([*FFMPEG, '-i', exact, *AS_OTHERS_ASK, theirs])

    def figures(film):
        said = measure(['ffmpeg', '-nostdin', '-nostats', '-i', film, '-i', exact, '-lavfi',
                        '[0]split[a][b];[1]split[c][d];[a][c]psnr;[b][d]ssim', '-f', 'null', '-']).stderr
        psnr_dB, ssim = (float(re.search(pattern, said)[1]) for pattern in [r'average:(\S+)', r'All:(\S+)'])
        return [f'{film.stat().st_size / 1e6:.2f} MB', f'{psnr_dB:.2f} dB', f'{ssim:.5f}']
    return table(['film of the same frames', 'size', 'PSNR', 'SSIM'],
                 [['poinsot', *figures(ours)], ['x264 alone', *figures(theirs)]])


def vtk(output, smoothing):
    return lambda frames: ['xvfb-run', '-a', '-s', f'-screen 0 {WIDTH}x{HEIGHT}x24',
                           PYTHON, '-B', HERE / 'vtk_peer.py', output, frames, smoothing]


def matplotlib():
    return lambda frames: [PYTHON, '-B', HERE / 'matplotlib_peer.py', 'film.mp4', frames]


def against(job, results):
    """Returns a table that compares each result with the first, which is this program's."""
    ours = results[0]
    return table([job, 'frames', 'wall', 'frames/s', 'CPU per frame', 'peak memory', "poinsot's frames/s to its",
                  "poinsot's CPU to its"],
                 [[result.job.what, str(result.job.frames), seconds(result.wall_s), f'{result.rate_hz:.1f}',
                   milliseconds(result.cpu_per_frame_s), mebibytes(result.memory_mib),
                   ratio(ours.rate_hz / result.rate_hz), ratio(ours.cpu_per_frame_s / result.cpu_per_frame_s)]
                  for result in results])


def beside_its_encoder(film):
    """Returns a table of the film's CPU time and of the part that encoding takes: the step `encode` alone, and with
    `convert`, from RGB to YUV. This program's settings of x264 need less time than `-preset medium`."""
    steps_s = {step: ms / 1e3 for step, ms in film.split.per_frame_ms.items()}
    encoders = {'its x264, from RGB': steps_s['encode'] + steps_s['convert'], 'its x264, from YUV': steps_s['encode']}
    return table(["poinsot's film, within", 'CPU per frame', "poinsot's CPU to its"],
                 [[what, milliseconds(cpu_s), ratio(film.cpu_per_frame_s / cpu_s)]
                  for what, cpu_s in encoders.items()])
