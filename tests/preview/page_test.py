# SPDX-License-Identifier: Apache-2.0
"""Tests the page of `poinsot preview` in a real browser: plays, steps and turns the picture; edits, breaks and repairs the
scene; renders a film.

    page_test.py PROGRAM SCREENSHOT
"""
import pathlib
import subprocess
import sys
import tempfile
import time

from preview_page import previewing, until
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

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
"""
ALWAYS = ['style.file=own.toml']


def check(program, page, scene, screenshot):
    until('the first picture', lambda: page.shown().get('frame') == 0)
    first = page.picture()
    page.press(Keys.END)
    until('the last frame', lambda: page.shown()['frame'] == 119)
    assert page.picture() != first
    page.press(Keys.ARROW_LEFT)
    until('a step back', lambda: page.shown()['frame'] == 118)
    page.press(Keys.HOME)
    until('the first frame', lambda: page.shown()['frame'] == 0)
    assert page.picture() == first

    page.press(' ')
    until('the film plays', lambda: page.shown()['frame'] > 30)
    page.press(' ')
    at = page.shown()['frame']
    time.sleep(0.3)
    assert page.shown()['frame'] - at < 5, 'it stands still again'

    page.press(Keys.HOME)
    until('the first frame', lambda: page.shown()['frame'] == 0)
    before = page.shown()['version']
    scene.write_text(SCENE + '[style]\ntheme = "dark"\n')
    edited_s = until('the edited scene', lambda: page.shown()['version'] > before)
    assert page.picture() != first
    page.driver.save_screenshot(screenshot)
    # A fixed size, because the messages take room from a picture that fits the window.
    page.choose('size', '480')
    until('a picture of the chosen size', lambda: page.shown()['width'] == 480)
    dark = page.picture()
    scene.write_text(SCENE.replace('mass', 'maas'))
    until('the mistake', lambda: page.find('error').is_displayed())
    assert 'did you mean body.mass?' in page.find('error').text, page.find('error').text
    assert '^^^^' in page.find('error').text
    assert page.picture() == dark, 'the last good picture stays'
    page.choose('size', '')
    scene.write_text(SCENE)
    until('no mistake', lambda: not page.find('error').is_displayed())
    until('the picture as it was', lambda: page.picture() == first)

    ActionChains(page.driver).move_to_element(page.find('picture')).click_and_hold().move_by_offset(60, 20).release().perform()
    until('the camera has turned', lambda: page.find('lines').is_displayed() and page.picture() != first)
    assert page.find('lines').text.startswith('[camera]\nazimuth = "'), page.find('lines').text
    assert scene.read_text() == SCENE, 'nothing is written'
    (scene.parent / 'turned.toml').write_text(SCENE + page.find('lines').text + '\n')
    page.find('back').click()
    until('the camera is back', lambda: page.picture() == first)

    scene.write_text(SCENE + '[camera]\nframes = ["space", "body"]\n')
    until('two views', lambda: page.find('view').is_displayed() and page.shown()['version'] > before and page.picture() != first)
    both = page.picture()
    page.driver.execute_script('const view = document.getElementById("view"); view.value = "1"; view.onchange();')
    until('one of them', lambda: page.picture() not in (both, first))
    scene.write_text(SCENE)
    until('one view', lambda: not page.find('view').is_displayed() and page.picture() == first)

    page.find('film').click()
    until('the film', lambda: page.find('filmState').text in ('ready', 'failed'), 120)
    assert page.find('filmState').text == 'ready', page.find('error').text
    film = scene.parent / 'out' / 'a.mp4'
    assert film.stat().st_size > 1000
    assert page.find('filmWith').text == 'as in the file', page.find('filmWith').text

    # The film has the changes of the page, and equals the film that `render` makes with the same options.
    page.choose('theme', 'dark')
    page.choose('frame', 'body')
    ActionChains(page.driver).move_to_element(page.find('picture')).click_and_hold().move_by_offset(40, 10).release().perform()
    until('the changes', lambda: page.find('changed').text.count('camera.') == 4)
    words = page.find('changed').text.split('\n')
    assert words[:2] == ['camera.frame="body"', 'style.theme="dark"'], words
    page.find('film').click()
    until('the other film begins', lambda: page.find('filmState').text != 'ready')
    until('the other film', lambda: page.find('filmState').text in ('ready', 'failed'), 120)
    assert page.find('filmWith').text == 'with ' + ', '.join(words), page.find('filmWith').text
    asked = [word for text in [*ALWAYS, *words] for word in ('-D', text)]
    subprocess.run([program, 'render', 'a.toml', *asked, '--asset-root', 'shared', '--quiet', '-o', 'own.mp4'], cwd=scene.parent, check=True)
    assert (scene.parent / 'own.mp4').read_bytes() == film.read_bytes()
    assert scene.read_text() == SCENE, 'nothing is written'
    complaints = page.driver.get_log('browser')
    assert not complaints, complaints
    return edited_s


def main(program, screenshot):
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / 'a.toml'
        scene.write_text(SCENE)
        (pathlib.Path(folder) / 'shared').mkdir()
        (pathlib.Path(folder) / 'shared' / 'own.toml').write_text('[style.colors]\nomega = "#AA2200"\n')
        # The film, too, needs --asset-root of the preview.
        words = ['a.toml', '-D', *ALWAYS, '--asset-root', 'shared']
        with previewing(program, folder, words, 1500, 900) as page:
            edited_s = check(program, page, scene, screenshot)
        subprocess.run([program, 'check', 'turned.toml'], cwd=folder, check=True)
        print(f'from saving to the picture: {1000 * edited_s:.0f} ms')


if __name__ == '__main__':
    main(*sys.argv[1:])
