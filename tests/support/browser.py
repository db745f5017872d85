# SPDX-License-Identifier: Apache-2.0
"""Starts Debian's headless Chromium with Debian's selenium."""

from selenium import webdriver
from selenium.webdriver.chrome.service import Service


def browser(width, height):
    """Starts a browser. get_log('browser') returns the error messages of its pages."""
    options = webdriver.ChromeOptions()
    for word in ('--headless=new', '--no-sandbox', f'--window-size={width},{height}'):
        options.add_argument(word)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
    return webdriver.Chrome(options=options, service=Service('/usr/bin/chromedriver'))
