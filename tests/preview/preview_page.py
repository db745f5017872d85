# SPDX-License-Identifier: Apache-2.0
"""Drives the page of `poinsot preview` in a browser, for the tests of the page."""
import contextlib
import json
import pathlib
import subprocess
import sys
import time

from selenium.webdriver.common.by import By

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / 'support'))
from browser import browser  # noqa: E402


class Page:
    def __init__(self, driver):
        self.driver = driver

    def find(self, name):
        return self.driver.find_element(By.ID, name)

    def shown(self):
        """Returns frame, version and width of the picture on the page."""
        return json.loads(self.driver.execute_script('return document.body.dataset.shown') or '{}')

    def choose(self, name, value):
        self.driver.execute_script('const list = document.getElementById(arguments[0]); list.value = arguments[1]; list.onchange();', name, value)

    def press(self, *keys):
        self.driver.find_element(By.TAG_NAME, 'body').send_keys(*keys)

    def picture(self):
        """Returns a checksum of the pixels."""
        return self.driver.execute_script('''
            const shown = document.getElementById("picture"), canvas = document.createElement("canvas");
            canvas.width = shown.width; canvas.height = shown.height;
            const on = canvas.getContext("2d", {willReadFrequently: true}); on.drawImage(shown, 0, 0);
            let sum = 7; for (const b of on.getImageData(0, 0, canvas.width, canvas.height).data) sum = (sum * 31 + b) % 1000003;
            return sum;''')


def until(what, true, most_s=30):
    begin = time.monotonic()
    while not true():
        assert time.monotonic() - begin < most_s, f'waited in vain: {what}'
        time.sleep(0.005)
    return time.monotonic() - begin


@contextlib.contextmanager
def previewing(program, folder, words, width, height, **process):
    """Runs `poinsot preview` in a folder, and yields its page in a new browser."""
    server = subprocess.Popen([program, 'preview', *words], cwd=folder, stdout=subprocess.PIPE, text=True, **process)
    driver = browser(width, height)
    try:
        driver.get(server.stdout.readline().strip())
        yield Page(driver)
    finally:
        driver.quit()
        server.terminate()
        ended = server.wait(20)
    assert ended in (0, 143), ended
