# SPDX-License-Identifier: Apache-2.0
"""What Sphinx makes of the staged pages (pages.py). Nothing is fetched from elsewhere, when it is built or when it is read."""
project = 'poinsot'
copyright = 'the authors of poinsot; Apache License 2.0'
extensions = ['myst_parser']
templates_path = []

# Links to headings, by the names that a repository's browser gives them; a wrong one is a warning, and so an error.
myst_heading_anchors = 4
myst_enable_extensions = ['colon_fence']
highlight_language = 'none'
smartquotes = False  # pages are shown as they are written: -- begins an option

html_theme = 'furo'
html_title = 'poinsot'
html_static_path = ['static']
html_css_files = ['site.css']
html_js_files = [('films.js', {'defer': 'defer'})]
html_copy_source = False
html_show_sphinx = False
html_show_search_summary = False  # it is fetched, which a browser refuses to pages that are files
_blue, _light_blue = '#0072b2', '#56b4e9'  # of L: the program's own palette
html_theme_options = {
    'light_css_variables': {'color-brand-primary': _blue, 'color-brand-content': _blue},
    'dark_css_variables': {'color-brand-primary': _light_blue, 'color-brand-content': _light_blue},
}
pygments_style = 'friendly'
