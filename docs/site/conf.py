# SPDX-License-Identifier: Apache-2.0
"""Sphinx settings for the staged pages (pages.py). Neither building nor reading the site needs a network."""
project = 'poinsot'
copyright = 'the authors of poinsot; Apache License 2.0'
extensions = ['myst_parser']
templates_path = []

# Anchors of headings, named as on a repository's web pages. A wrong link is a warning, and warnings are errors.
myst_heading_anchors = 4
myst_enable_extensions = ['colon_fence']
highlight_language = 'none'
smartquotes = False  # because -- begins an option, and must be shown as written

html_theme = 'furo'
html_title = 'poinsot'
html_static_path = ['static']
html_css_files = ['site.css']
html_js_files = [('films.js', {'defer': 'defer'})]
html_copy_source = False
html_show_sphinx = False
html_show_search_summary = False  # browsers do not let pages that are files fetch a summary
_blue, _light_blue = '#0072b2', '#56b4e9'  # colours of L in the program's palette
html_theme_options = {
    'light_css_variables': {'color-brand-primary': _blue, 'color-brand-content': _blue},
    'dark_css_variables': {'color-brand-primary': _light_blue, 'color-brand-content': _light_blue},
}
pygments_style = 'friendly'
