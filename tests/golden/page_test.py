# SPDX-License-Identifier: Apache-2.0
"""The pages of `poinsot golden --report` and `poinsot diff --report` in a real browser: a suite's is sorted, its slider
is moved, the failing row found; on a film's curve a frame is chosen.

    page_test.py PROGRAM SCREENSHOT
"""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


def png(path, colour_at, width=64, height=48):
    rows = b''.join(b'\0' + b''.join(bytes(colour_at(x, y)) for x in range(width)) for y in range(height))
    chunk = lambda kind, data: (struct.pack('>I', len(data)) + kind + data
                                + struct.pack('>I', zlib.crc32(kind + data)))
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0))
                     + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def pixels_of(data):
    """Colours of a PNG of 8 bits without interlace, as Chromium writes it."""
    at, parts, size = 8, b'', None
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        if kind == b'IHDR':
            size = struct.unpack('>IIBB', data[at + 8:at + 18])
        if kind == b'IDAT':
            parts += data[at + 8:at + 8 + length]
        at += 12 + length
    width, height, _, colour = size
    bpp = {2: 3, 6: 4}[colour]
    raw, rows, stride = zlib.decompress(parts), [], width * bpp
    before = bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = line[i - bpp] if i >= bpp else 0
            b, c = before[i], before[i - bpp] if i >= bpp else 0
            if kind == 4:
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = (line[i] + (0, a, b, (a + b) // 2, near if kind == 4 else 0)[kind]) & 255
        rows.append(line)
        before = line
    return lambda x, y: tuple(rows[y][x * bpp:x * bpp + 3])


RED, BLUE, GREY = (200, 30, 30), (30, 60, 200), (128, 128, 128)


def suite(program, folder):
    """Three tests of pictures: one the same, one a little brighter, one of another colour."""
    environment = {**os.environ, 'CI': ''}
    names = ['same', 'brighter', 'recoloured']
    tests = ''.join(f"[[test]]\nimage = '{name}.png'\n" for name in names)
    (folder / 'golden.toml').write_text(tests)
    for name in names:
        png(folder / f'{name}.png', lambda x, y: RED if name == 'recoloured' else GREY)
    subprocess.run([program, 'golden', '--update'], cwd=folder, env=environment, check=True)
    png(folder / 'brighter.png', lambda x, y: tuple(v + 1 for v in GREY) if (x, y) == (5, 5) else GREY)
    png(folder / 'recoloured.png', lambda x, y: BLUE)
    made = subprocess.run([program, 'golden', '--report', 'report.html'], cwd=folder, env=environment)
    assert made.returncode == 1, made.returncode
    return folder / 'report.html'


def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = '/usr/bin/chromium'
    for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
                     '--window-size=1280,800', '--force-device-scale-factor=1'):
        options.add_argument(argument)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
    return webdriver.Chrome(service=Service('/usr/bin/chromedriver'), options=options)


class Page:
    def __init__(self, driver):
        self.driver = driver

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def names(self):
        return [row.get_attribute('data-name') for row in self.driver.find_elements(By.CSS_SELECTOR, 'tbody tr')]

    def sort_by(self, column):
        self.find(f'th[data-column={column}] button').click()

    def mode(self, name):
        self.find(f'.modes button[data-mode={name}]').click()

    def colour_at(self, share):
        """Of the stage in its middle row, that far from its left edge."""
        stage = self.find('#stage')
        at = pixels_of(stage.screenshot_as_png)
        return at(int(share * stage.size['width']), stage.size['height'] // 2)


def expect(value, expected, what):
    assert value == expected, f'{what}: {value!r}, not {expected!r}'


def close(colour, expected):
    return all(abs(a - b) <= 3 for a, b in zip(colour, expected))


def check(driver, report, screenshot):
    driver.get(report.as_uri())
    page = Page(driver)
    expect(page.find('#counts').text, '1 different, 1 near, 1 identical', 'counts')
    # What fails stands first, and is shown.
    expect(page.names(), ['recoloured', 'brighter', 'same'], 'order by status')
    expect(page.find('tr[aria-selected=true]').get_attribute('data-name'), 'recoloured', 'shown first')
    assert 'largest difference 170 (limit 2)' in page.find('#message').text, page.find('#message').text

    page.sort_by('name')
    expect(page.names(), ['brighter', 'recoloured', 'same'], 'order by name')
    page.sort_by('name')
    expect(page.names(), ['same', 'recoloured', 'brighter'], 'order by name, downwards')
    page.sort_by('flip')
    expect(page.names(), ['recoloured', 'brighter', 'same'], 'order by FLIP')

    page.mode('slider')
    expect(close(page.colour_at(0.2), RED) and close(page.colour_at(0.8), BLUE), True, 'the slider in the middle')
    slider = page.find('#slider')
    for _ in range(60):
        slider.send_keys(Keys.ARROW_RIGHT)
    expect(slider.get_attribute('value'), '100', 'the slider moved')
    expect(close(page.colour_at(0.8), RED), True, 'the slider at its end shows what was approved')
    for _ in range(90):
        slider.send_keys(Keys.ARROW_LEFT)
    expect(close(page.colour_at(0.2), BLUE), True, 'the slider at 10 shows what is new')
    driver.save_screenshot(screenshot)

    page.mode('blink')
    seen = set()
    for _ in range(12):
        seen.add(page.find('#stage img').get_attribute('alt'))
        time.sleep(0.2)
    expect(seen, {'approved', 'new'}, 'blinking')

    page.mode('flip')
    assert page.colour_at(0.5) != (0, 0, 4), 'a map that sees nothing'
    page.find('tr[data-name=same]').click()
    expect(page.find('#view h2').text, 'same', 'another test')
    page.find('body').send_keys(Keys.ARROW_UP)
    expect(page.find('#view h2').text, 'brighter', 'the arrow key')

    expect_nothing_loaded(driver)


def expect_nothing_loaded(driver):
    loaded = driver.execute_script("return performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length")
    expect(loaded, 0, 'loaded from elsewhere')
    expect([e for e in driver.get_log('browser') if e['level'] == 'SEVERE'], [], 'errors')


def films(program, folder):
    """Two of 41 frames that differ in the 11th and the 31st."""
    for name, odd in (('a', []), ('b', [10, 30])):
        frames = folder / name
        frames.mkdir()
        for k in range(41):
            png(frames / f'{k:02}.png', lambda x, y: BLUE if k in odd else GREY)
        subprocess.run(['ffmpeg', '-v', 'error', '-framerate', '10', '-i', frames / '%02d.png', '-c:v', 'ffv1',
                        '-pix_fmt', 'bgr0', folder / f'{name}.mkv'], check=True)
    made = subprocess.run([program, 'diff', 'a.mkv', 'b.mkv', '--report', 'film.html'], cwd=folder)
    expect(made.returncode, 1, 'exit code of different films')
    return folder / 'film.html'


def check_film(driver, report, screenshot):
    driver.get(report.as_uri())
    page = Page(driver)
    expect(page.find('#counts').text, '41 frames: 39 identical, 2 different', 'counts')
    expect(page.names(), ['10', '30'], 'the frames that differ')
    curve = page.find('#curve')
    expect(curve.is_displayed(), True, 'the curve')
    picture = page.find('#curve img')
    expect(driver.execute_script('return arguments[0].complete && arguments[0].naturalWidth > 0', picture), True,
           'the curve is a picture')
    for share, name in ((0.7, '30'), (0.3, '10')):
        click = ActionChains(driver).move_to_element_with_offset(curve, int((share - 0.5) * curve.size['width']), 0)
        click.click().perform()
        expect(page.find('#view h2').text, name, f'a click at {share}')
        cursor = page.find('#curve i').rect['x'] + 1 - curve.rect['x']
        moment = (cursor / curve.rect['width'] - 0.055) / 0.93  # where the axis begins and how long it is
        expect(abs(moment - int(name) / 40) < 0.01, True, f'the cursor, at {moment}')
    expect(close(page.colour_at(0.2), GREY) and close(page.colour_at(0.8), BLUE), True, 'both frames')
    driver.save_screenshot(screenshot)
    expect_nothing_loaded(driver)


def main():
    program, screenshot = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        report, film = suite(program, folder), films(program, folder)
        driver = browser()
        try:
            check(driver, report, screenshot)
            check_film(driver, film, screenshot.replace('.png', '_film.png'))
        finally:
            driver.quit()


main()
