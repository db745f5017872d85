# SPDX-License-Identifier: Apache-2.0
"""Drives a page of pictures in headless Chromium as a reader would, and writes and reads small PNG files."""
import base64
import json
import pathlib
import struct
import time
import urllib.parse
import zlib

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By


def png(path, colour_at, width=64, height=48):
    rows = b''.join(b'\0' + b''.join(bytes(colour_at(x, y)) for x in range(width)) for y in range(height))
    chunk = lambda kind, data: (struct.pack('>I', len(data)) + kind + data
                                + struct.pack('>I', zlib.crc32(kind + data)))
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0))
                     + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def pixels_of(data):
    """Returns the function (x, y) -> colour of an 8-bit PNG without interlace, as Chromium writes it."""
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


def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = '/usr/bin/chromium'
    for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
                     '--window-size=1280,800', '--force-device-scale-factor=1'):
        options.add_argument(argument)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
    return webdriver.Chrome(service=Service('/usr/bin/chromedriver'), options=options)


def until(true, what, most_s=20):
    begin = time.monotonic()
    while not true():
        assert time.monotonic() - begin < most_s, f'{what}: waited in vain'
        time.sleep(0.05)


class Page:
    def __init__(self, driver, file, name=''):
        self.driver, self.file = driver, file
        driver.get('about:blank')
        driver.get_log('performance')
        driver.get(file.as_uri() + name)
        self.settle()

    def settle(self):
        """Waits until all pictures are loaded and two frames were drawn."""
        until(lambda: self.script("return [...document.querySelectorAll('#view img')].every(i => i.complete)"), 'pictures')
        self.driver.execute_async_script('requestAnimationFrame(() => requestAnimationFrame(arguments[0]))')

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def window(self, width, height):
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': width, 'height': height, 'deviceScaleFactor': 1, 'mobile': False})
        self.settle()

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        return [element.text for element in self.all(selector)]

    def names(self):
        return [row.get_attribute('data-name') for row in self.all('#rows li[data-name]') if row.is_displayed()]

    def sort_by(self, column):
        self.find(f'#sort option[value="{column}"]').click()

    def choose(self, name):
        row = next(row for row in self.all('#rows li') if row.get_attribute('data-name') == name)
        self.script('arguments[0].scrollIntoView({block: "center"})', row)  # a click misses a row that still moves
        self.settle()
        row.click()
        self.settle()

    def mode(self, name):
        self.find(f'#modes button[data-mode={name}]').click()
        self.settle()

    def press(self, *keys):
        for key in keys:
            self.find('body').send_keys(key)
        self.settle()

    def rect(self, element):
        return self.script('const r = arguments[0].getBoundingClientRect(); return [r.left, r.top, r.width, r.height]', element)

    def scale(self, image):
        return self.rect(image)[2] / self.script('return arguments[0].naturalWidth', image)

    def on_screen(self, image, x, y):
        """Returns the place on the screen of the centre of a picture's pixel."""
        left, top, _, _ = self.rect(image)
        return left + (x + 0.5) * self.scale(image), top + (y + 0.5) * self.scale(image)

    def screen_colour(self, x, y):
        clip = {'x': int(x), 'y': int(y), 'width': 1, 'height': 1, 'scale': 1}
        shot = self.driver.execute_cdp_cmd('Page.captureScreenshot', {'format': 'png', 'clip': clip})
        return pixels_of(base64.b64decode(shot['data']))(0, 0)

    def colour(self, x, y, selector='#stage img'):
        """Returns the colour on the screen at a picture's pixel."""
        return self.screen_colour(*self.on_screen(self.find(selector), x, y))

    def loaded(self):
        """Returns the names of the files that were loaded since the last call."""
        events = [json.loads(entry['message'])['message'] for entry in self.driver.get_log('performance')]
        urls = [event['params']['request']['url'] for event in events if event['method'] == 'Network.requestWillBeSent']
        return {urllib.parse.unquote(pathlib.PurePosixPath(urllib.parse.urlparse(url).path).name) for url in urls
                if not url.startswith(('data:', 'about:'))}

    def finish(self, loaded=()):
        """Expects no errors, and that exactly the named files were loaded."""
        expect(sorted(self.loaded() - {self.file.name}), sorted(loaded), 'loaded')
        expect([e for e in self.driver.get_log('browser') if e['level'] == 'SEVERE'], [], 'errors')


def expect(value, expected, what):
    assert value == expected, f'{what}: {value!r}, not {expected!r}'


def close(colour, expected, most=3):
    return all(abs(a - b) <= most for a, b in zip(colour, expected))


def expect_colour(colour, expected, what, most=3):
    assert close(colour, expected, most), f'{what}: {colour}, not {expected}'
