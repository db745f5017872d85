# SPDX-License-Identifier: Apache-2.0
"""Tests the buttons, keys, layout and downloads of the page of `poinsot preview` in a real browser. Expected files are
those that `poinsot still` writes.

    controls_test.py PROGRAM
"""
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

from preview_page import previewing, until
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

# Frames at 30 a second: the entries begin at frame 0, at frame 39, and between frames 75 and 76.
SCENE = """[body]
shape = "box"
size = [0.24, 0.17, 0.03]
mass = 1
[motion]
omega_body = [0.04, 3, 0.04]
[time]
duration = 4
[output]
size = [320, 180]
[[timeline]]
at = 0
caption = 'The start'
[[timeline]]
at = 1.3
speed = 0.5
speed_for = 1
[[timeline]]
at = 2.51
caption = 'The end'
"""
MISTAKES = SCENE.replace('mass', 'maas').replace('duration = 4', 'duration = "4 kg"')
WINDOWS = [(800, 600), (1600, 900), (1920, 1080)]


def frame_is(page, frame):
    until(f'frame {frame}', lambda: page.shown().get('frame') == frame)


def click(page, name):
    page.find(name).click()


def is_playing(page):
    return page.find('play').get_attribute('aria-label') == 'pause'


def is_pressed(page, name):
    return page.find(name).get_attribute('aria-pressed') == 'true'


def resize(page, width, height):
    page.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {'width': width, 'height': height, 'deviceScaleFactor': 1, 'mobile': False})


def check_steps(page):
    frame_is(page, 0)
    click(page, 'stepOn')
    click(page, 'stepOn')
    frame_is(page, 2)
    click(page, 'stepBack')
    frame_is(page, 1)
    page.press(Keys.SHIFT, Keys.ARROW_RIGHT)
    frame_is(page, 31)
    page.press(Keys.NULL, Keys.HOME)
    frame_is(page, 0)


def check_speed(page):
    assert page.find('speed').text == '1×'
    for _ in range(3):
        click(page, 'slower')
    assert page.find('speed').text == '1/8×' and not page.find('slower').is_enabled()
    begin = time.monotonic()
    click(page, 'play')
    until('three frames', lambda: page.shown()['frame'] >= 3)
    # Frame 3 is due after 0.8 s. At the usual speed, it would be due after 0.1 s.
    assert time.monotonic() - begin > 0.7
    page.press(' ')
    until('a pause', lambda: not is_playing(page))
    for _ in range(5):
        page.press('+')
    assert page.find('speed').text == '4×' and not page.find('faster').is_enabled()


def check_loop(page):
    """Expects speed 4, at which the film of 4 s lasts 1 s."""
    assert is_pressed(page, 'loop')
    click(page, 'loop')
    assert not is_pressed(page, 'loop')
    page.press(Keys.HOME)
    frame_is(page, 0)
    begin = time.monotonic()
    click(page, 'play')
    frame_is(page, 119)
    assert 0.9 < time.monotonic() - begin < 3.5, time.monotonic() - begin
    until('the film stops at its end', lambda: not is_playing(page))
    page.press('l')
    assert is_pressed(page, 'loop')
    page.press(Keys.END)
    page.press(Keys.ARROW_LEFT)
    frame_is(page, 118)
    page.press(' ')
    until('the film begins again', lambda: page.shown()['frame'] < 90)
    assert is_playing(page)
    page.press(' ')
    for _ in range(2):
        page.press('-')


def check_timeline(page):
    entries = page.find('entries').find_elements(By.TAG_NAME, 'button')
    texts = [' '.join(entry.text.split()) for entry in entries]
    assert texts == ['0.00 s “The start”', '1.30 s speed 0.5 for 1 s', '2.51 s “The end”'], texts
    entries[1].click()
    frame_is(page, 39)
    assert [entry.get_attribute('aria-current') for entry in entries] == [None, 'true', None]
    page.press('n')
    frame_is(page, 76)
    assert not page.find('next').is_enabled()
    page.press('p')
    frame_is(page, 39)
    click(page, 'previous')
    frame_is(page, 0)
    marks = page.find('marks').find_elements(By.TAG_NAME, 'button')
    assert len(marks) == 3
    marks[2].click()
    frame_is(page, 76)
    page.press(Keys.ARROW_LEFT)
    frame_is(page, 75)
    assert entries[1].get_attribute('aria-current') == 'true'


def downloaded(folder, name):
    file = folder / name
    until(name, lambda: file.exists() and file.stat().st_size > 0)
    return file.read_bytes()


def check_still(program, page, folder, downloads):
    """Expects frame 75, at 2.5 s."""
    page.choose('theme', 'dark')
    click(page, 'still')
    saved = downloaded(downloads, 'a_2500ms.png')
    subprocess.run([program, 'still', 'a.toml', '--time', '2.5', '-D', 'style.theme=dark', '-o', 'own_2500ms.png', '--quiet'], cwd=folder, check=True)
    assert saved == (folder / 'own_2500ms.png').read_bytes()
    page.choose('theme', '')


def check_figures(program, page, folder, downloads):
    """Runs the command of the page in another folder, and compares its files with those that the browser saves."""
    other = folder / 'other'
    other.mkdir()
    (other / 'a.toml').write_text(SCENE)
    page.press('g')
    until('the dialog', lambda: page.find('figureBox').is_displayed())
    for kind, files in [('pdf', ['a_2500ms.pdf']), ('svg', ['a_2500ms.svg']), ('tex', ['a_2500ms.tex', 'a_2500ms-unlabelled.png'])]:
        page.driver.find_element(By.CSS_SELECTOR, f'input[value={kind}]').click()
        until('the command', lambda: page.find('command').text.endswith('.' + kind))
        command = shlex.split(page.find('command').text)
        assert command == ['poinsot', 'still', 'a.toml', '--time', '2.5', '-o', f'out/a_2500ms.{kind}'], command
        subprocess.run([program, *command[1:], '--quiet'], cwd=other, check=True)
        click(page, 'download')
        for name in files:
            assert downloaded(downloads, name) == (other / 'out' / name).read_bytes(), name
        until('the end of the download', lambda: page.find('download').text == 'Download')
        assert not page.find('figureError').is_displayed()
    page.driver.execute_cdp_cmd('Browser.grantPermissions', {'permissions': ['clipboardReadWrite', 'clipboardSanitizedWrite']})
    click(page, 'copyCommand')
    until('a copy', lambda: page.find('copyCommand').text == 'Copied')
    page.driver.switch_to.active_element.send_keys(Keys.ESCAPE)
    until('no dialog', lambda: not page.find('figureBox').is_displayed())


def check_help(page):
    page.press('?')
    until('the help', lambda: page.find('helpBox').is_displayed())
    text = page.find('keys').text
    for key in ['Space', '←', '→', 'Home', 'End', 'P', 'N', '-', '+', 'L', 'S', 'G', 'F', 'I', 'E', '?']:
        assert f'{key} ' in text, key
    frame = page.shown()['frame']
    page.driver.switch_to.active_element.send_keys(Keys.ARROW_LEFT)
    page.driver.switch_to.active_element.send_keys(Keys.ESCAPE)
    until('no help', lambda: not page.find('helpBox').is_displayed())
    assert page.shown()['frame'] == frame, 'the keys belong to the dialog'
    click(page, 'help')
    until('the help again', lambda: page.find('helpBox').is_displayed())
    box = page.driver.execute_script('const b = document.getElementById("helpBox"); return [b.scrollHeight, b.clientHeight];')
    assert box[0] <= box[1], f'the help needs no scrolling: {box}'
    page.driver.switch_to.active_element.send_keys(' ')  # on the button Close
    until('no help again', lambda: not page.find('helpBox').is_displayed())


def check_full_screen(page):
    page.press('f')
    until('full screen', lambda: page.driver.execute_script('return Boolean(document.fullscreenElement)'))
    until('the picture alone', lambda: not page.find('physics').is_displayed() and is_pressed(page, 'full'))
    assert page.find('play').is_displayed() and page.find('picture').is_displayed()
    click(page, 'full')
    until('the window again', lambda: page.find('physics').is_displayed())
    page.press('i')
    until('more room', lambda: not page.find('physics').is_displayed())
    click(page, 'side')
    until('the numbers', lambda: page.find('physics').is_displayed())


def check_layout(page, parts):
    """Checks that no part covers another one, that each is inside the window, and that each control can be clicked."""
    boxes = page.driver.execute_script('''
        return arguments[0].map(name => { const b = document.querySelector(name).getBoundingClientRect(); return [b.left, b.top, b.right, b.bottom]; })''', parts)
    width, height = page.driver.execute_script('return [innerWidth, innerHeight]')
    for name, (left, top, right, bottom) in zip(parts, boxes):
        assert left >= 0 and top >= 0 and right <= width and bottom <= height, (name, left, top, right, bottom)
        assert right - left > 20 and bottom - top > 10, (name, left, top, right, bottom)
        for other, (x0, y0, x1, y1) in zip(parts, boxes):
            apart = right <= x0 + .5 or x1 <= left + .5 or bottom <= y0 + .5 or y1 <= top + .5
            assert name == other or apart, f'{name} covers {other} at {width}x{height}'
    covered = page.driver.execute_script('''
        return [...document.querySelectorAll("header select, header button, #controls button, #time, #fold")].filter(e => e.offsetParent).filter(e => {
            const b = e.getBoundingClientRect();
            return document.elementFromPoint((b.left + b.right) / 2, (b.top + b.bottom) / 2) !== e && !e.contains(document.elementFromPoint((b.left + b.right) / 2, (b.top + b.bottom) / 2));
        }).map(e => e.id)''')
    assert not covered, covered


def check_windows(page, scene):
    usual, wrong = ['header', '#picture', 'aside', 'footer'], ['header', '#picture', '#error', 'aside', 'footer']
    for size in WINDOWS:
        resize(page, *size)
        scene.write_text(SCENE)
        until('no mistake', lambda: not page.find('error').is_displayed())
        check_layout(page, usual)
        scene.write_text(MISTAKES)
        until('the mistakes', lambda: page.find('error').is_displayed())
        assert page.find('summary').text == '2 mistakes', page.find('summary').text
        assert 'a.toml:4:1: error: body.maas: unknown key; did you mean body.mass?' in page.find('details').text
        assert 'a.toml:8:12: error: time.duration: ' in page.find('details').text
        check_layout(page, wrong)
        unfolded = page.find('error').size['height']
        click(page, 'fold')
        assert page.find('summary').text.startswith('2 mistakes: a.toml:4:1: error: body.maas: unknown key'), page.find('summary').text
        assert not page.find('details').is_displayed()
        assert page.find('error').size['height'] < min(60, unfolded)
        check_layout(page, wrong)
        page.press('e')
        until('all messages', lambda: page.find('details').is_displayed())
    scene.write_text(SCENE)
    until('no mistake', lambda: not page.find('error').is_displayed())


def check(program, page, folder, downloads):
    page.driver.execute_cdp_cmd('Browser.setDownloadBehavior', {'behavior': 'allow', 'downloadPath': str(downloads)})
    check_steps(page)
    check_speed(page)
    check_loop(page)
    check_timeline(page)
    check_still(program, page, folder, downloads)
    check_figures(program, page, folder, downloads)
    resize(page, 800, 600)
    check_help(page)
    check_full_screen(page)
    check_windows(page, folder / 'a.toml')
    complaints = page.driver.get_log('browser')
    assert not complaints, complaints


def check_sweep(program, page, folder, downloads):
    page.driver.execute_cdp_cmd('Browser.setDownloadBehavior', {'behavior': 'allow', 'downloadPath': str(downloads)})
    frame_is(page, 0)
    page.press('n')
    frame_is(page, 39)
    click(page, 'still')
    saved = downloaded(downloads, 'a_sweep_1300ms.png')
    subprocess.run([program, 'sweep', 'a.toml', *RANGE, '--time', '1.3', '-o', 'own_1300ms.png', '--quiet'], cwd=folder, check=True)
    assert saved == (folder / 'own_1300ms.png').read_bytes()
    page.press('g')
    until('the command', lambda: page.find('command').text)
    command = shlex.split(page.find('command').text)
    assert command == ['poinsot', 'sweep', 'a.toml', '--time', '1.3', '-o', 'out/a_sweep_1300ms.pdf', *RANGE], command
    complaints = page.driver.get_log('browser')
    assert not complaints, complaints


RANGE = ['-D', 'motion.omega_body=[0.1..0.2:2, 3, 0]']


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        downloads, temporary = folder / 'downloads', folder / 'tmp'
        downloads.mkdir()
        temporary.mkdir()
        (folder / 'a.toml').write_text(SCENE)
        environment = {**os.environ, 'TMPDIR': str(temporary)}
        with previewing(program, folder, ['a.toml'], 1500, 900, env=environment) as page:
            check(program, page, folder, downloads)
        assert not (folder / 'out').exists(), 'only the browser writes'
        assert (folder / 'a.toml').read_text() == SCENE
        left = [file.name for file in temporary.iterdir()]
        assert not left, f'files remain: {left}'
        with previewing(program, folder, ['a.toml', *RANGE], 800, 600, env=environment) as page:
            check_sweep(program, page, folder, downloads)


if __name__ == '__main__':
    main(*sys.argv[1:])
