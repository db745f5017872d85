# SPDX-License-Identifier: Apache-2.0
"""Tests approval picture by picture: a reader decides on the page in a browser, and git applies the patch in a clean clone.
`golden approve` must do the same. Oracle: git, and the bytes of the new pictures.

    approval_page_test.py PROGRAM SCREENSHOT
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from page_driver import Page, browser, expect, png, until

GREY, BLUE = (128, 128, 128), (30, 60, 200)
NAMES = ['large', 'late', "n\u00e4me with 'blanks'", 'sub/inner', 'z_last']
ENVIRONMENT = {**os.environ, 'CI': '', 'GIT_CONFIG_GLOBAL': '/dev/null', 'GIT_AUTHOR_NAME': 'a', 'GIT_AUTHOR_EMAIL': 'a@b',
               'GIT_COMMITTER_NAME': 'a', 'GIT_COMMITTER_EMAIL': 'a@b'}


def run(*words, cwd, code=0):
    done = subprocess.run(words, cwd=cwd, env=ENVIRONMENT, capture_output=True, text=True)
    assert done.returncode == code, f'{words}: {done.returncode}\n{done.stdout}{done.stderr}'
    return done.stdout + done.stderr


def noise(seed):
    """Returns a picture that does not compress, so that its file is larger than a block of zlib."""
    return lambda x, y: ((x * 7919 + y * 104729 + seed) * 2654435761 >> 11 & 255,) * 2 + ((x * y * 31 + seed) >> 3 & 255,)


def new_pictures(folder):
    for name in NAMES:
        (folder / f'{name}.png').parent.mkdir(parents=True, exist_ok=True)
        png(folder / f'{name}.png', noise(7) if name == 'large' else lambda x, y: BLUE, *((200, 200) if name == 'large' else (64, 48)))


def project(program, folder):
    """Makes a git repository with a suite below its root, whose pictures have all changed. Returns the folder of the suite."""
    suite = folder / 'tests'
    suite.mkdir(parents=True)
    (folder / '.gitignore').write_text('made/\nout/\n')
    (suite / 'golden.toml').write_text('references = "approved"\n[[test]]\nimage = "made/**/*.png"\n')
    for name in NAMES:
        (suite / f'made/{name}.png').parent.mkdir(parents=True, exist_ok=True)
        png(suite / f'made/{name}.png', noise(1) if name == 'large' else lambda x, y: GREY, *((200, 200) if name == 'large' else (64, 48)))
    run(program, 'golden', '--update', '--only', *NAMES[:-1], cwd=suite)  # z_last has no reference yet
    run('git', 'init', '-q', '.', cwd=folder)
    run('git', 'add', '.', cwd=folder)
    run('git', 'commit', '-qm', 'before', cwd=folder)
    new_pictures(suite / 'made')
    run(program, 'golden', '--report', 'out/report.html', cwd=suite, code=1)
    return suite


def clone(folder, name):
    target = folder.parent / name
    run('git', 'clone', '-q', folder, target, cwd=folder.parent)
    return target


def changed(repository):
    lines = run('git', '-c', 'core.quotePath=false', 'status', '--porcelain', '-uall', cwd=repository).splitlines()
    return sorted(line[3:].strip('"') for line in lines)


def save_patch(driver, page, downloads):
    driver.execute_cdp_cmd('Browser.setDownloadBehavior', {'behavior': 'allow', 'downloadPath': str(downloads)})
    page.find('#patch').click()
    patch = downloads / 'approved.patch'
    until(patch.exists, 'the patch')
    until(lambda: patch.stat().st_size > 0 and not list(downloads.glob('*.crdownload')), 'the whole patch')
    return patch


def decide_group(page):
    """Three pictures changed alike. The list folds the one in the middle, and one key decides on all of them."""
    expect(page.find('.group-head b').text.lstrip('▸▾ '), '3 alike', 'the group')
    expect(len(page.names()), len(NAMES) - 1, 'rows beside the folded one')
    page.find('.group-head .why').click()
    expect(sorted(page.names()), sorted(NAMES), 'rows')
    page.choose('late')
    page.press('A')
    expect(page.find('footer b').text, '3 approved, 2 open', 'the group is approved')
    expect(page.find('footer input').get_attribute('value').split()[-1], 'sub/inner', 'the command')
    page.choose('sub/inner')
    page.press('R')
    expect(page.find('footer b').text, '3 rejected, 2 open', 'the group is rejected')
    page.find('.group-head input').click()
    expect(page.find('footer b').text, '3 approved, 2 open', 'the box of the group')
    page.find('#unmark').click()


def decide(page):
    """Approves all pictures except `late`, which is rejected, with the keys alone."""
    page.sort_by(1)
    page.choose(NAMES[0])
    expect(page.find('footer').is_displayed(), False, 'nothing is decided')
    page.press('a')
    expect(page.find('#view h2').text, 'late', 'the next picture that is open')
    page.press('r', 'a', 'a', 'a')
    expect(page.find('footer b').text, '4 approved, 1 rejected', 'counts')
    page.choose('sub/inner')
    page.press('a')
    expect(page.find('footer b').text, '3 approved, 1 rejected, 1 open', 'one approval taken back')
    page.press('a')


def check_patch(driver, suite, page, downloads):
    repository = suite.parent
    patch = save_patch(driver, page, downloads)
    clean = clone(repository, 'clean')
    run('git', 'apply', '--check', patch, cwd=clean)
    run('git', 'apply', patch, cwd=clean)
    approved = [name for name in NAMES if name != 'late']
    for name in approved:
        expect((clean / f'tests/approved/{name}.png').read_bytes(), (suite / f'made/{name}.png').read_bytes(), name)
    pictures = [name for name in changed(clean) if name.endswith('.png')]
    expect(pictures, sorted(f'tests/approved/{name}.png' for name in approved), 'pictures that the patch changes')
    other = clone(repository, 'other')
    png(other / 'tests/approved/large.png', lambda x, y: GREY)
    run('git', 'apply', patch, cwd=other, code=1)
    expect(changed(other), ['tests/approved/large.png'], 'a patch for another picture changes nothing')
    return clean


def check_command(program, suite, page, clean):
    """The command changes the same files, also where only the page is. @param clean: a clone with the patch applied"""
    command = page.find('footer input').get_attribute('value')
    assert command.startswith('poinsot golden approve out/report.html large '), command
    elsewhere = clone(suite.parent, 'elsewhere')
    shutil.copyfile(suite / 'out/report.html', elsewhere / 'report.html')
    names = [name for name in NAMES if name != 'late']
    said = run(program, 'golden', 'approve', 'report.html', *names, cwd=elsewhere)
    expect(len(said.splitlines()), 4, said)
    (elsewhere / 'report.html').unlink()
    expect(changed(elsewhere), changed(clean), 'the same files')
    for name in changed(clean):
        expect((elsewhere / name).read_bytes(), (clean / name).read_bytes(), name)
    # The suite passes then, with the new pictures, except for the rejected one.
    shutil.copytree(suite / 'made', elsewhere / 'tests/made')
    assert '4 identical, 1 different' in run(program, 'golden', cwd=elsewhere / 'tests', code=1)


def check_refusals(program, suite):
    late = suite / 'approved/late.png'
    before = late.read_bytes()
    report = suite / 'out/report.html'
    refused = lambda *words, code=4: run(program, 'golden', 'approve', report, *words, cwd=suite, code=code)
    png(late, lambda x, y: BLUE, 32, 32)
    assert 'approved/late.png: changed since the report was written' in refused('large', 'late')
    expect((suite / 'approved/large.png').read_bytes() == (suite / 'made/large.png').read_bytes(), False, 'nothing is approved then')
    late.unlink()
    assert 'changed since the report was written' in refused('late')
    late.symlink_to('large.png')
    assert 'is a link, which is not replaced' in refused('late')
    late.unlink()
    late.write_bytes(before)
    assert "did you mean 'large'?" in refused('lage', code=2)
    report.write_text(report.read_text() + ' ')
    assert 'is not a report of poinsot' in refused('late'), 'an edited report'
    ci = subprocess.run([program, 'golden', 'approve', report, 'late'], cwd=suite, env={**ENVIRONMENT, 'CI': '1'}, capture_output=True, text=True)
    assert ci.returncode == 2 and 'golden approve: not possible while the environment variable CI is set' in ci.stderr, ci.stderr


def main():
    program, screenshot = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        suite = project(program, folder / 'project')
        (folder / 'downloads').mkdir()
        driver = browser()
        try:
            page = Page(driver, suite / 'out/report.html')
            decide_group(page)
            decide(page)
            driver.save_screenshot(screenshot)
            clean = check_patch(driver, suite, page, folder / 'downloads')
            check_command(program, suite, page, clean)
            page.find('#unmark').click()
            expect(page.find('footer').is_displayed(), False, 'cleared')
        finally:
            driver.quit()
        check_refusals(program, suite)


main()
