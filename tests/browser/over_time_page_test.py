#!/usr/bin/env python3
"""Opens over_time.html in headless Chromium and tests its slider.

usage: over_time_page_test.py DIR      DIR: directory of `fpkcheck run --until T --snapshots 4 --out DIR`

Exit code 77 (skipped) when Chromium, its driver or Selenium is not installed.
"""
import csv
import pathlib
import sys
import unittest

import report_page_test  # exits with code 77 without Chromium and Selenium
from report_page_test import DESKTOP, PHONE, RELATIVE_ROUNDING
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

SMALLEST = 1e-37  # smaller numbers have fewer digits in 32-bit floating point
DIRECTORY = None  # set by main
PLOT = 'over-time-density-y'


class OverTimePage(unittest.TestCase):
    def setUp(self):
        self.browser = report_page_test.open_browser()
        self.addCleanup(self.browser.quit)
        self.open_page(DESKTOP)

    def open_page(self, size):
        self.browser.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': size[0], 'height': size[1], 'deviceScaleFactor': 1, 'mobile': size == PHONE})
        self.browser.get((DIRECTORY / 'over_time.html').resolve().as_uri())
        WebDriverWait(self.browser, 60).until(
            lambda _: self.script('return document.documentElement.dataset.plots') == 'drawn')
        self.slider = self.browser.find_element(By.ID, 'time')

    def script(self, code, *arguments):
        return self.browser.execute_script(code, *arguments)

    def densities(self):
        """{solution: p(y) at the selected time}"""
        return self.script('''
            const curves = document.getElementById(arguments[0])._fullData.filter(
                t => t.yaxis === 'y' && t.hoverinfo !== 'skip');
            return Object.fromEntries(curves.map(t => [t.legendgroup, Array.from(t.y)]));''', PLOT)

    def visible_captions(self):
        return [e.text for e in self.browser.find_elements(By.CSS_SELECTOR, '[data-slider] caption') if e.is_displayed()]

    def test_1_the_keyboard_selects_the_time(self):
        with open(DIRECTORY / 'over_time.csv', newline='') as file:
            rows = [row for row in csv.DictReader(file) if row['variable'] == 'y']
        times = sorted({float(row['time']) for row in rows})
        self.assertEqual(len(times), 5)
        for key, place in ((Keys.END, 4), (Keys.ARROW_LEFT, 3), (Keys.HOME, 0), (Keys.ARROW_RIGHT, 1)):
            self.slider.send_keys(key)
            label = f't = {times[place]:g}'
            self.assertEqual(self.browser.find_element(By.ID, 'time-label').text, label)
            self.assertEqual(self.slider.get_attribute('aria-valuetext'), label)
            self.assertEqual(self.visible_captions(), ['Moments and L1 distances at ' + label])
            found = self.densities()
            self.assertEqual(set(found), {row['solution'] for row in rows})
            for solution, density in found.items():
                expected = [float(row['density']) for row in rows
                            if row['solution'] == solution and float(row['time']) == times[place]]
                self.assertEqual(len(density), len(expected))
                for a, b in zip(density, expected):
                    self.assertLessEqual(abs(a - b), RELATIVE_ROUNDING * abs(b) + SMALLEST, (solution, label))
        self.assertEqual(self.browser.get_log('browser'), [])

    def test_2_a_hidden_solution_remains_hidden(self):
        self.script('''
            const plot = document.getElementById(arguments[0]);
            const indices = plot.data.flatMap((t, k) => t.legendgroup === 'epc-polar-n4' ? [k] : []);
            Plotly.restyle(plot, {visible: 'legendonly'}, indices);''', PLOT)
        self.slider.send_keys(Keys.END)
        visible = self.script('''
            return [...document.querySelectorAll('.plot')].flatMap(plot => plot.data.filter(
                t => t.legendgroup === 'epc-polar-n4').map(t => t.visible));''')
        self.assertGreater(len(visible), 6)
        self.assertEqual(set(visible), {'legendonly'})

    def test_3_fits_screens_of_both_widths(self):
        for size in (DESKTOP, PHONE):
            self.open_page(size)
            self.assertLessEqual(self.script('return document.documentElement.scrollWidth'), size[0])
            right = self.script('return [...document.querySelectorAll(".plot, #time, #time-label")].map('
                                'e => e.getBoundingClientRect().right)')
            self.assertEqual(len(right), 8)
            self.assertLessEqual(max(right), size[0])


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    DIRECTORY = pathlib.Path(sys.argv.pop(1))
    unittest.main(verbosity=2)
