# SPDX-License-Identifier: Apache-2.0
"""Tests the pages of `poinsot golden --report` and `poinsot diff --report` in a real browser, in narrow and wide windows.
Framed, magnified, painted and blended pixels must have the colours that follow from the test's pictures. Rows are sorted,
filtered, marked and linked to. Pictures that are not embedded are loaded from their files.

    page_test.py PROGRAM SCREENSHOT
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.parse

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.keys import Keys

from page_driver import Page, browser, close, expect, expect_colour, until
from page_inputs import BLACK, BLUE, COMMIT, GREY, HOSTILE, RED, WHITE, films, ignored, many, pairs, suite


def check_rows(page):
    expect(page.texts('#chips button'), ['1 error', '2 different', '1 new', '1 unused', '1 near', '1 identical'], 'chips')
    worst_first = ['torn', 'recoloured', 'lost', 'fresh', 'gone', 'brighter']
    expect(page.names(), worst_first, 'worst first, without the identical one')
    expect(page.find('li[aria-selected=true]').get_attribute('data-name'), 'torn', 'shown first')
    page.find('#chips button.identical').click()
    expect(page.names(), worst_first + ['same'], 'with the identical one')
    page.sort_by(1)
    by_name = ['brighter', 'fresh', 'gone', 'lost', 'recoloured', 'same', 'torn']
    expect(page.names(), by_name, 'by name')
    page.find('#turn').click()
    expect(page.names(), by_name[::-1], 'by name, downwards')
    page.sort_by(2)
    # |200 - 30| = 170 in red and in blue; |128 - 30| = 98; 1; 0
    expect(page.names()[:4], ['recoloured', 'lost', 'brighter', 'same'], 'by the largest difference')
    expect([row.text for row in page.all('#rows .figure')][:4], ['170', '98', '1', '0'], 'largest differences')
    page.find('#chips button.different').click()
    expect(page.names()[:2], ['brighter', 'same'], 'without different ones')
    page.find('#chips button.different').click()
    page.find('#find').send_keys('one PLACE of 20x12')
    expect(page.names(), ['lost'], 'filtered by what changed')
    page.find('#find').send_keys(' nothing')
    expect(page.find('#none').is_displayed(), True, 'what is said where nothing matches')
    page.find('#find').send_keys(Keys.ESCAPE)
    page.find('#find').clear()
    page.find('#find').send_keys(' ', Keys.ESCAPE)
    page.sort_by(0)


def check_lost_block(page):
    """Checks a picture that lost a block of 20x12 at (300, 200), blue on grey."""
    page.choose('lost')
    expect(page.find('#words').text, 'different: 240 pixels in one place of 20x12 px at (300, 200), #1e3cc8 became #808080', 'why')
    expect(page.driver.current_url.split('#')[1], 'lost', 'the address')
    expect(len(page.all('#stage .frame')), 1, 'frames')
    left, top, width, height = page.rect(page.find('#stage .frame'))
    x, y = page.on_screen(page.find('#stage img'), 309.5, 205.5)
    assert abs(left + width / 2 - x) < 1 and abs(top + height / 2 - y) < 1, 'the frame is about the block'
    expect_colour(page.colour(310, 206), GREY, 'the new picture within the frame')
    expect_colour(page.colour(50, 50), [0.4 * 128 + 0.6 * 255] * 3, 'the rest, under 60 % of the white page')
    for selector, colour in ('figure:first-child', BLUE), ('figure:nth-child(2)', GREY):
        image = page.find(f'#near {selector} img')
        expect_colour(page.screen_colour(*page.on_screen(image, 310, 206)), colour, f'near, {selector}')
        times = page.scale(image)
        assert times >= 1 and times == round(times), f'{times}: a whole multiple'
        caption = page.find(f'#near {selector} figcaption').text
        assert caption.endswith(', 1:1' if times == 1 else f', {times:.0f} times'), caption
    page.press('5')
    expect_colour(page.colour(310, 206), (0.9 * 255, 0, 127.5), 'painted')
    # Grey is 127.75 at half the contrast, 159.7 at 1.25 times the brightness.
    expect_colour(page.colour(50, 50), [159.7] * 3, 'pale')
    page.press('6')
    expect_colour(page.colour(310, 206), WHITE, 'differences of 98, 68 and 72, 16 times')
    expect_colour(page.colour(50, 50), BLACK, 'no difference')


def check_modes(page):
    page.choose('brighter')
    page.mode('difference')
    expect_colour(page.colour(5, 5), (16, 16, 16), 'a difference of one level, 16 times', 0)
    page.choose('recoloured')
    page.mode('slider')
    expect_colour(page.colour(12, 24), RED, 'left of the slider')
    expect_colour(page.colour(52, 24), BLUE, 'right of the slider')
    slider = page.find('#slider')
    slider.send_keys(*[Keys.ARROW_RIGHT] * 60)
    expect(slider.get_attribute('value'), '100', 'the slider moved')
    expect_colour(page.colour(52, 24), RED, 'the slider at its end shows what was approved')
    slider.send_keys(*[Keys.ARROW_LEFT] * 90)
    expect_colour(page.colour(12, 24), BLUE, 'the slider at 10 shows what is new')
    page.press('b')
    seen = set()
    for _ in range(12):
        seen.add((page.find('#stage figcaption').text, RED if close(page.colour(30, 20), RED) else BLUE))
        time.sleep(0.15)
    assert {('approved', RED), ('new', BLUE)} <= seen, seen
    page.mode('flip')
    assert page.colour(30, 20) != (0, 0, 4), 'a map that sees nothing'
    page.press('1')


def check_zoom(page):
    page.choose('lost')
    page.press('2')
    images = page.all('#stage img')
    panes = page.all('#stage .pane')

    def seen():
        """Returns the scale of each picture, and its place in its pane."""
        return [[round(v, 2) for v in (page.scale(image), page.rect(image)[0] - page.rect(pane)[0],
                                       page.rect(image)[1] - page.rect(pane)[1])] for image, pane in zip(images, panes)]

    def linked(what):
        now = seen()
        expect(now[0], now[1], what)
        return now[0]

    fit = linked('whole pictures')
    page.press('z')
    expect((linked('at 1:1')[0], page.find('#zoom').text), (1, '100 %'), '1:1')
    page.press('+')
    expect(linked('larger')[0], 1.5, 'larger')
    page.press('-', '-')
    expect(linked('smaller')[0], 0.67, 'smaller')
    page.find('[data-zoom=one]').click()
    ActionChains(page.driver).scroll_from_origin(ScrollOrigin.from_element(panes[0]), 0, -1000).perform()
    page.settle()
    now = linked('by the wheel')
    assert now[0] > 2, now
    expect('crisp' in page.find('#stage').get_attribute('class'), True, 'pixels stay squares')
    ActionChains(page.driver).drag_and_drop_by_offset(panes[1], -30, -20).perform()
    page.settle()
    after = linked('dragged')
    expect([round(a - b, 1) for a, b in zip(after, now)], [0, -30, -20], 'dragged by')
    page.press('0')
    expect(linked('whole again'), fit, 'whole again')
    page.press('1')
    page.script("document.querySelector('#figures').open = true")
    page.find('#worst').click()
    page.settle()
    # All pixels of the block differ equally, and the first counts as the worst.
    x, y = page.on_screen(page.find('#stage img'), 300, 200)
    left, top, width, height = page.rect(page.find('#stage .pane'))
    assert abs(left + width / 2 - x) < 1.5 and abs(top + height / 2 - y) < 1.5, 'the worst pixel is in the middle'
    expect((page.find('#worst').text, page.find('#zoom').text), ('(300, 200)', '800 %'), 'the worst pixel')
    page.press('0')


def check_alone(page):
    """Checks rows with only one picture to show."""
    for name, caption, colour, words in (('torn', 'approved; the other picture cannot be read', GREY, 'the file ends too early'),
                                         ('fresh', 'new', BLUE, 'nothing was approved yet'),
                                         ('gone', 'approved', GREY, 'no test makes it')):
        page.choose(name)
        expect(page.texts('#modes button'), ['Picture'], name)
        expect(page.find('#stage figcaption').text, caption, name)
        expect_colour(page.colour(20, 20), colour, name)
        assert words in page.find('#message').text, page.find('#message').text


def check_keys(page):
    page.choose('torn')
    for key, name in ((Keys.ARROW_DOWN, 'recoloured'), ('j', 'lost'), ('k', 'recoloured'), (Keys.ARROW_UP, 'torn')):
        page.press(key)
        expect(page.find('#view h2').text, name, f'key {key!r}')
    expect(page.find('footer').is_displayed(), False, 'nothing is marked')
    page.press('a')
    expect(page.find('footer').is_displayed(), False, 'a torn one cannot be approved')
    page.press('j', 'a')
    expect(page.find('#view h2').text, 'lost', 'the next row that is open')
    page.press('a')
    expect(page.find('footer input').get_attribute('value'), 'poinsot golden approve report.html recoloured lost', 'the command')
    page.choose('lost')
    page.press('a')
    expect(page.find('footer b').text, '1 approved, 3 open', 'one is approved no more')
    page.find('#copy').click()
    until(lambda: page.find('#copy').text == 'Copied', 'copying')
    page.find('#find').clear()
    page.find('#find').send_keys(Keys.CONTROL, 'v')
    expect(page.find('#find').get_attribute('value').strip(), 'poinsot golden approve report.html recoloured', 'copied')
    page.find('#find').clear()
    page.find('#find').send_keys(' ', Keys.ESCAPE)
    page.find('#unmark').click()
    expect(page.find('footer').is_displayed(), False, 'cleared')


def check_suite(driver, report, screenshot):
    page = Page(driver, report)
    check_rows(page)
    check_lost_block(page)
    check_modes(page)
    check_zoom(page)
    check_alone(page)
    check_keys(page)
    page.finish()
    page.choose('same')
    expect(page.find('#stage figcaption').text, 'approved and new are identical', 'an identical one')
    expect_colour(page.colour(20, 20), GREY, 'an identical one, from its file')
    page.choose('lost')
    driver.save_screenshot(screenshot)
    page.finish(['same.png'])


def check_pairs(driver, report):
    page = Page(driver, report, '#two.png')
    expect(page.find('#view h2').text, 'two.png', 'chosen by the address')
    expect(page.find('#words').text,
           'different: 350 pixels in 2 places, the largest of 30x10 px at (20, 20), #1e3cc8 became #808080 in 300 of them', 'why')
    expect(page.find('#place span').text, 'place 1 of 2: 300 pixels, 30×10 px at (20, 20)', 'the largest')
    page.press('n')
    expect(page.find('#place span').text, 'place 2 of 2: 50 pixels, 10×5 px at (200, 100)', 'the next')
    expect_colour(page.colour(204, 102, '#near img'), RED, 'the next, near')
    page.press('n')
    page.all('#stage .frame')[1].click()
    page.settle()
    expect(page.find('#place span').text[:12], 'place 2 of 2', 'the place that was clicked')
    page.find('#near figure').click()
    page.settle()
    x, y = page.on_screen(page.find('#stage img'), 204.5, 102)
    left, top, width, height = page.rect(page.find('#stage .pane'))
    assert left < x < left + width and top < y < top + height, 'the place is in view'

    page.choose('moved.png')
    expect(page.find('#words').text, 'different: the picture moved by 1 px to the right', 'moved')
    page.choose('size.png')
    expect(page.texts('#modes button'), ['Side by side', 'Slider', 'Blink', 'Overlay', 'Difference'], 'views of two sizes')
    expect(page.texts('#stage figcaption'), ['reference 64×48', 'test 80×60'], 'sizes')
    for mode in ('side', 'slider', 'blink', 'difference'):
        page.mode(mode)
        a, b = page.all('#stage img')
        assert abs(page.scale(a) - page.scale(b)) < 1e-3, f'{mode}: stretched'
        if mode != 'side':
            expect(page.rect(a)[:2], page.rect(b)[:2], f'{mode}: from the top left')
    expect(page.find('#near').is_displayed(), False, 'no places of two sizes')

    for name, caption, colour in (('gone.png', 'reference; missing in test', BLUE), ('more.png', 'test', RED),
                                  ('torn.png', 'reference; the other picture cannot be read', BLUE)):
        page.choose(name)
        expect(page.find('#stage figcaption').text, caption, name)
        expect_colour(page.colour(20, 20), colour, name)
    assert 'not a readable PNG: the file ends too early' in page.find('#message').text, page.find('#message').text
    expect(page.find('#words').text, 'error', 'status of a torn one')

    page.choose(HOSTILE)
    page.press('a')
    page.choose('two.png')
    page.press('a')
    command = page.find('footer input').get_attribute('value')
    words = subprocess.run(['bash', '-c', 'printf "%s\\0" ' + command], capture_output=True, check=True).stdout.decode().split('\0')
    expect(words[:5] + sorted(words[5:-1]), ['poinsot', 'golden', 'approve', 'pairs.html', HOSTILE, 'two.png'], 'the command, as bash reads it')

    facts = dict(zip(*[page.script(f"return [...document.querySelectorAll('#run {tag}')].map(e => e.textContent)") for tag in ('dt', 'dd')]))
    assert re.fullmatch(r'\d{4}-\d\d-\d\d \d\d:\d\d:\d\d [+-]\d{4}', facts.pop('date')), 'the date'
    assert facts.pop('program').startswith('poinsot '), 'the program'
    expect(facts, {'commit': COMMIT, 'machine': os.uname().nodename, 'command': f'{pathlib.Path(sys.argv[1]).name} diff old new --report pairs.html'},
           'the run')
    assert COMMIT[:10] in page.find('#run summary').text, page.find('#run summary').text
    page.finish()
    page = Page(driver, report, '#' + urllib.parse.quote(HOSTILE))
    expect(page.find('#view h2').text, HOSTILE, 'a hostile name in the address')
    page.script("location.hash = '#same.png'")
    until(lambda: page.find('#view h2').text == 'same.png', 'another address')
    expect('same.png' in page.names(), True, 'the row of an identical one that is linked to')


def check_many(driver, report):
    """Checks that the page embeds the hundred worst pairs, and loads k0 and identical pairs only when they are shown."""
    page = Page(driver, report)
    expect((len(page.all('#rows li')), len(page.names())), (402, 101), 'rows, and those that are shown')
    assert len(page.all('img')) < 10, 'pictures that are not shown'
    expect(page.names()[0::100], ['k100.png', 'k0.png'], 'the worst and the least')
    page.choose('k1.png')
    page.finish()
    page.choose('k0.png')
    page.mode('side')
    expect([page.script('return i = document.querySelectorAll("#stage img")[arguments[0]].naturalWidth', k) for k in (0, 1)], [4, 4], 'loaded')
    expect('FLIP' in page.texts('#modes button'), False, 'no map without a file')
    page.mode('difference')
    expect_colour(page.colour(1, 1), WHITE, 'a difference of 100 without a file, 16 times')
    page.finish(['k0.png'])
    (report.parent / 'm_new/k0.png').unlink()
    page = Page(driver, report, '#k0.png')
    assert page.find('#stage .lost').text.startswith('m_new/k0.png cannot be loaded.'), page.find('#stage .lost').text
    driver.get_log('browser')  # drops the error about the missing file


def check_ignored(driver, report):
    """Checks that every view hatches the ignored box, and that the box is not a changed place."""
    page = Page(driver, report)
    expect(page.find('#words').text, 'different: 1 pixel at (100, 70), #808080 became #ffffff', 'what changed')
    for mode in ('changes', 'side', 'overlay'):
        page.mode(mode)
        hatched = page.all('#stage .ignored')
        expect(len(hatched), 2 if mode == 'side' else 1, 'hatched places')
        left, top, wide, high = page.rect(page.find('#stage img'))
        for found, wanted in zip(page.rect(hatched[0]), (left, top, wide, high / 4)):
            assert abs(found - wanted) < 1.5, (mode, page.rect(hatched[0]), (left, top, wide, high / 4))
    figures = page.script("return document.querySelector('#figures dl').textContent")
    assert 'ignored25 % of the picture' in figures, figures
    page.finish()


def check_widths(driver, reports):
    """Checks that the picture fits into windows from 700 px of width on, without scrolling."""
    for width, height in ((720, 640), (1100, 700), (1920, 1080)):
        for report in reports:
            page = Page(driver, report)
            page.window(width, height)
            for row in page.names()[:8]:
                page.choose(row)
                where = f'{report.name}, {row}, {width} px'
                expect(page.script('const d = document.documentElement; return [d.scrollWidth, d.scrollHeight]'), [width, height], where)
                left, top, wide, high = page.rect(page.find('#stage'))
                assert left >= 0 and top >= 0 and left + wide <= width and top + high <= height, where
                assert wide >= 0.5 * width and high >= 128, f'{where}: {wide}x{high}'
                _, top, _, high = page.rect(page.find('#stage img'))
                assert top + high <= height, where
    driver.execute_cdp_cmd('Emulation.clearDeviceMetricsOverride', {})


def check_film(driver, report, screenshot):
    page = Page(driver, report)
    expect(page.find('#counts').text, '41 frames: 39 identical, 2 different', 'counts')
    expect(page.names(), ['10', '30'], 'the frames that differ')
    curve = page.find('#curve')
    expect(curve.is_displayed(), True, 'the curve')
    picture = page.find('#curve img')
    expect(page.script('return arguments[0].complete && arguments[0].naturalWidth > 0', picture), True, 'the curve is a picture')
    for share, name in ((0.7, '30'), (0.3, '10')):
        click = ActionChains(driver).move_to_element_with_offset(curve, int((share - 0.5) * curve.size['width']), 0)
        click.click().perform()
        page.settle()
        expect(page.find('#view h2').text, 'Frame ' + name, f'a click at {share}')
        cursor = page.find('#curve i').rect['x'] + 1 - curve.rect['x']
        moment = (cursor / curve.rect['width'] - 0.055) / 0.93  # start and length of the axis
        expect(abs(moment - int(name) / 40) < 0.01, True, f'the cursor, at {moment}')
    expect(page.all('#rows input'), [], 'frames are not approved')
    page.mode('side')
    expect([page.colour(20, 20, f'#stage figure:nth-child({k}) img') for k in (1, 2)], [GREY, BLUE], 'both frames')
    driver.save_screenshot(screenshot)
    page.finish()


def main():
    program, screenshot = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in ('suite', 'pairs', 'many', 'films', 'ignored'):
            (folder / part).mkdir()
        report, both = suite(program, folder / 'suite'), pairs(program, folder / 'pairs')
        all_of_them, film = many(program, folder / 'many'), films(program, folder / 'films')
        driver = browser()
        try:
            check_suite(driver, report, screenshot)
            check_pairs(driver, both)
            check_ignored(driver, ignored(program, folder / 'ignored'))
            check_film(driver, film, screenshot.replace('.png', '_film.png'))
            check_widths(driver, [report, both, film])
            check_many(driver, all_of_them)
        finally:
            driver.quit()


main()
