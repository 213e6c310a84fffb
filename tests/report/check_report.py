#!/usr/bin/env python3
"""Drives a report of `silhouettes compare` in Chromium: looks, words, keyboard, phone, paper. Exit code 1 on any fault.

    check_report.py REPORT-DIR [--screenshots DIR]
    check_report.py REPORT-DIR --controls    also breaks copies of the report, each of which must be found faulty

Needs Playwright for Python (`pip install playwright`) and a Chromium, of the system or of Playwright; $CHROMIUM names another.
Without them it says so and exits with 77.
"""

import argparse
import json
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

MAX_BYTES = 25_000_000
WIDTHS = (1400, 400)
SCHEMES = ("light", "dark")
SKIPPED = 77

# Texts whose contrast with what lies behind them is below what the Web Content Accessibility Guidelines ask for (AA).
CONTRAST = """() => {
  const context = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const rgba = (color) => {
    context.clearRect(0, 0, 1, 1);
    context.fillStyle = color;
    context.fillRect(0, 0, 1, 1);
    return [...context.getImageData(0, 0, 1, 1).data];
  };
  const over = (top, under) => under.map((value, at) => (top[at] * top[3] + value * (255 - top[3])) / 255);
  const ground = (element) => {
    const layers = [];
    for (let at = element; at; at = at.parentElement) layers.push(rgba(getComputedStyle(at).backgroundColor));
    return layers.reverse().reduce((under, top) => over(top, under), [255, 255, 255]);
  };
  const luminance = (color) => {
    const [r, g, b] = color.map((value) => {
      const share = value / 255;
      return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const faults = new Map();
  let count = 0;
  const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let text = words.nextNode(); text; text = words.nextNode()) {
    const element = text.parentElement;
    if (!text.data.trim() || ["SCRIPT", "STYLE", "OPTION", "TITLE"].includes(element.tagName.toUpperCase())) continue;
    if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const style = getComputedStyle(element);
    const isDrawn = element instanceof SVGElement;
    const behind = ground(element);
    const front = over(rgba(isDrawn ? style.fill : style.color), behind).slice(0, 3);
    const [low, high] = [luminance(front), luminance(behind)].sort((a, b) => a - b);
    const ratio = (high + 0.05) / (low + 0.05);
    const size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    count += 1;
    if (ratio < (isLarge ? 3 : 4.5)) {
      faults.set(`${element.tagName}.${element.getAttribute("class")}`, `${ratio.toFixed(2)} "${text.data.trim().slice(0, 40)}"`);
    }
  }
  return { count, faults: [...faults].map(([where, what]) => `${where}: ${what}`) };
}"""

# What reaches beyond the right edge of the page, or of the box that holds it, without being scrolled there.
OVERFLOW = """() => {
  const faults = [];
  for (const element of document.querySelectorAll("main *")) {
    if (element.closest(".scroll, .chart, svg") || !element.checkVisibility()) continue;
    const right = element.getBoundingClientRect().right;
    if (right > innerWidth + 1) faults.push(`${element.tagName}.${element.className}: ${Math.round(right)} px`);
  }
  return { page: document.documentElement.scrollWidth - innerWidth, faults: faults.slice(0, 5) };
}"""

# What paper would not show: closed parts, answers that are not chosen, charts that are not drawn.
ON_PAPER = """() => {
  const unseen = (selector) => [...document.querySelectorAll(selector)].filter((element) => !element.checkVisibility());
  return {
    closed: unseen("details > :not(summary)").length,
    answers: unseen(".answer").length,
    sections: unseen("section, h2, h3, h4, table, figure, img").length,
    charts: [...document.querySelectorAll(".chart")].filter((chart) => !chart.querySelector("svg")).length,
    details: document.querySelectorAll("details").length,
    ground: getComputedStyle(document.body).backgroundColor,
  };
}"""


class Check:
    """One walk through a report; what is wrong is collected in `faults`."""

    def __init__(self, browser, report, screenshots=None):
        self.browser, self.report, self.screenshots = browser, report.resolve(), screenshots
        self.faults = []

    def expect(self, condition, fault):
        if not condition:
            self.faults.append(fault)

    def run(self, until=None):
        """Takes all steps, or those up to the first fault that holds the words `until`."""
        views = [(width, scheme) for width in WIDTHS for scheme in SCHEMES]
        steps = [lambda view=view: self.on_page(self.look, *view) for view in views]
        tasks = (self.choose_error, self.choose_answer, self.move_divider, self.tab_through, self.trace_rows, self.print)
        steps += [lambda task=task: self.on_page(task, WIDTHS[0], "light") for task in tasks]
        steps.append(lambda: self.on_page(self.without_scripts, WIDTHS[1], "light", scripts=False))
        for step in steps:
            try:
                step()
            except Exception as error:  # a page that does not answer is a fault like any other
                self.faults.append(str(error).splitlines()[0])
            if until is not None and any(until in fault for fault in self.faults):
                break
        return self.faults

    def on_page(self, task, width, scheme, scripts=True):
        page = self.open(width, scheme, scripts)
        try:
            task(page, f"{width} px, {scheme}")
        finally:
            page.context.close()

    def open(self, width, scheme, scripts=True):
        context = self.browser.new_context(
            viewport={"width": width, "height": 1000}, color_scheme=scheme, java_script_enabled=scripts
        )
        page = context.new_page()
        page.set_default_timeout(30_000)
        where = f"{width} px, {scheme}"
        page.on("console", lambda message: message.type in ("error", "warning") and self.faults.append(
            f"{where}: console: {message.text[:200]}"))
        page.on("pageerror", lambda error: self.faults.append(f"{where}: exception: {error}"))
        page.on("requestfailed", lambda request: self.faults.append(f"{where}: failed: {request.url[:200]}"))
        folder = self.report.as_uri() + "/"
        inside = lambda url: url.startswith((folder, "data:", "blob:"))
        page.on("request", lambda request: inside(request.url) or self.faults.append(
            f"{where}: leaves the folder: {request.url[:200]}"))
        loaded = set()
        page.on("requestfinished", lambda request: loaded.add(request.url))
        page.goto(folder + "index.html")
        files = [Path(unquote(url.removeprefix("file://"))) for url in loaded if url.startswith("file://")]
        size = sum(path.stat().st_size for path in files)
        self.expect(0 < size < MAX_BYTES, f"{where}: opening the page loads {size} bytes")
        return page

    def shoot(self, page, name):
        if self.screenshots:
            self.screenshots.mkdir(parents=True, exist_ok=True)
            page.screenshot(path=self.screenshots / f"{re.sub('[^a-z0-9]+', '-', name)}.png")

    def look(self, page, where):
        chart = page.locator(".answer:not([hidden]) .chart").first
        chart.locator("svg").first.wait_for()
        self.shoot(page, f"{where} answer")
        method = page.locator("details.method").first
        method.locator("summary").first.click()
        method.scroll_into_view_if_needed()
        page.locator(f"#{method.get_attribute('id')} img").first.wait_for()
        page.wait_for_timeout(300)
        self.shoot(page, f"{where} method")
        page.evaluate("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
        contrast = page.evaluate(CONTRAST)
        self.expect(contrast["count"] > 100, f"{where}: contrast of {contrast['count']} texts only")
        self.faults += [f"{where}: contrast {fault}" for fault in contrast["faults"]]
        overflow = page.evaluate(OVERFLOW)
        self.expect(overflow["page"] <= 0, f"{where}: the page scrolls by {overflow['page']} px")
        self.faults += [f"{where}: wider than the page: {fault}" for fault in overflow["faults"]]
        dark = page.evaluate("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"
        self.expect(dark == where.endswith("dark"), f"{where}: the ground is of the other mode")

    def choose_error(self, page, _where):
        """Another error moves the dots, the sentence, the axis and the table; by keyboard."""
        answer = page.locator(".answer:not([hidden])")
        choice = answer.locator("select[data-measure]")
        chart = answer.locator(".chart")
        chart.locator("svg").first.wait_for()
        state = lambda: (
            answer.locator(".sentence").inner_text(),
            answer.locator("th.error").inner_text(),
            chart.evaluate("(element) => element.layout.yaxis.title.text"),
            chart.evaluate("(element) => JSON.stringify(element.data.map((trace) => trace.y))"),
        )
        before = state()
        choice.focus()
        page.keyboard.press("Home")
        page.wait_for_function("(old) => document.querySelector('.answer:not([hidden]) .sentence').textContent !== old", arg=before[0])
        after = state()
        for old, new, what in zip(before, after, ("sentence", "head of the table", "axis", "dots")):
            self.expect(old != new, f"the {what} does not follow the error")
        front = chart.evaluate("(element) => element.data[0].x.length")
        rows = answer.locator("table.front tbody tr:not([hidden])")
        self.expect(rows.count() == front, f"{rows.count()} rows for a front of {front}")
        times = rows.evaluate_all("(rows) => rows.map((row) => Number(row.cells[1].firstChild.textContent))")
        self.expect(times == sorted(times), f"the front is not in the order of time: {times}")

    def choose_answer(self, page, _where):
        which = page.locator("#which")
        if which.count() == 0:
            return
        which.focus()
        page.keyboard.press("ArrowDown")
        shown = page.locator(".answer:not([hidden])")
        self.expect(shown.count() == 1, f"{shown.count()} answers are shown")
        self.expect(shown.get_attribute("id") == which.input_value(), "the answer shown is not the chosen one")
        shown.locator(".chart svg").first.wait_for()

    def move_divider(self, page, _where):
        method = page.locator("details.method").first
        if not method.evaluate("(element) => element.open"):
            method.locator("summary").first.focus()
            page.keyboard.press("Enter")
        divider = method.locator(".pair input")
        divider.focus()
        cut = lambda: method.locator(".over").evaluate("(element) => getComputedStyle(element).clipPath")
        before = cut()
        for _ in range(10):
            page.keyboard.press("ArrowRight")
        self.expect(divider.input_value() == "60", f"ten presses move the divider to {divider.input_value()}")
        self.expect(cut() != before, "the pictures do not follow the divider")
        page.keyboard.press("Home")
        self.expect(divider.input_value() == "0", "Home does not show all of the truth")
        self.expect(bool(divider.get_attribute("aria-label")), "the divider has no name")

    def tab_through(self, page, _where):
        """The keyboard reaches every control in sight, shows where it is, and is caught nowhere."""
        page.locator("details.method").first.evaluate("(element) => { element.open = true; }")
        reached, invisible = set(), set()
        for _ in range(1500):
            page.keyboard.press("Tab")
            place = page.evaluate("""() => {
              const element = document.activeElement;
              if (element === document.body || !element.closest("main")) return null;
              element.dataset.reached = "yes";
              const ring = (one) => getComputedStyle(one).outlineStyle !== "none";
              const name = `${element.tagName}.${element.className}#${element.id}`;
              return [name, ring(element) || (element.parentElement.matches(".pair") && ring(element.parentElement))];
            }""")
            if place is None:
                break
            reached.add(place[0])
            if not place[1]:
                invisible.add(place[0])
        else:
            self.faults.append("Tab does not come to an end")
        self.expect(not invisible, f"the focus cannot be seen on {sorted(invisible)[:3]}")
        missed = page.evaluate("""() => [...document.querySelectorAll("main :is(a[href], select, input, summary)")]
            .filter((element) => element.checkVisibility() && !element.dataset.reached && !element.closest(".chart"))
            .map((element) => element.outerHTML.slice(0, 80))""")
        self.expect(not missed, f"Tab does not reach {missed[:3]}")
        self.expect(len(reached) > 5, f"Tab reaches {sorted(reached)}")

    def trace_rows(self, page, _where):
        """Rows of tables name lines of the results, and say the same of them."""
        cells = [json.loads(line) for line in (self.report / "results.jsonl").read_text().splitlines()]
        rows = page.evaluate("""() => [...document.querySelectorAll("tr[data-row] th[scope=row] .row")].map((row) => [
            Number(row.closest("tr").dataset.row), row.textContent, row.parentElement.childNodes[1].textContent])""")
        self.expect(len(rows) >= len(cells), f"{len(rows)} rows of tables for {len(cells)} lines of results")
        for number, words, method in rows:
            right = 1 <= number <= len(cells) and cells[number - 1]["method"] == method and words == f"row {number}"
            if not right:
                self.faults.append(f"row {number} ({words}) is not that of {method}")
                break
        medians = page.evaluate("""() => [...document.querySelectorAll("table.front tr[data-row]")].map((row) => [
            Number(row.dataset.row), Number(row.cells[1].firstChild.textContent)])""")
        for number, shown in medians:
            median = cells[number - 1]["frame"]["frame_ms"]["median"]
            self.expect(abs(shown - median) <= 0.0501 * max(1.0, shown / 10.0), f"row {number}: {shown} ms, in the results {median}")

    def print(self, page, _where):
        page.emulate_media(media="print", color_scheme="dark")
        page.wait_for_timeout(500)
        paper = page.evaluate(ON_PAPER)
        self.expect(paper["details"] > 0, "there are no methods")
        for what in ("closed", "answers", "sections", "charts"):
            self.expect(paper[what] == 0, f"paper hides {paper[what]} {what}")
        self.expect(paper["ground"] == "rgb(255, 255, 255)", f"paper is {paper['ground']}")
        self.shoot(page, "paper")
        page.emulate_media(media="screen", color_scheme="light")
        page.wait_for_function("matchMedia('screen').matches")
        page.wait_for_timeout(1000)
        shown = page.locator(".answer:not([hidden])").count()
        self.expect(shown == 1, f"after printing {shown} answers are shown")

    def without_scripts(self, page, _where):
        answers = page.locator(".answer")
        self.expect(answers.count() > 0, "there is no answer")
        for at in range(answers.count()):
            self.expect(answers.nth(at).is_visible(), "without scripts an answer is hidden")
            rows = answers.nth(at).locator("table.front tbody tr:not([hidden])")
            self.expect(rows.count() > 0, "without scripts an answer has no table")


# What is broken in a copy of a report, how, and a word that the fault must hold.
CONTROLS = {
    "an exception": (r"</body>", "<script>throw new Error('control')</script></body>", "exception: control"),
    "an error on the console": (r"</body>", "<script>console.error('control')</script></body>", "console: control"),
    "a picture from elsewhere": (r"<h1>", "<img src='https://example.invalid/a.png'><h1>", "example.invalid"),
    "a wide box": (r"<h1>", "<div style='width:900px'>wide</div><h1>", "400 px, light: the page scrolls"),
    "grey words": (r"<h1>", "<p style='color:#888'>pale</p><h1>", "contrast P.null"),
    "words lost on a dark ground": (r"--ink: #e8ebef", "--ink: #333333", "dark: contrast"),
    "a section that paper hides": (r"</style>", "@media print { #methods { display: none } }</style>", "paper hides"),
    "an error that moves nothing": (r'addEventListener\("change", \(\) => \{', 'addEventListener("never", () => {', "Timeout"),
    "a divider without a script": (r'divider.addEventListener\("input"', 'divider.addEventListener("never"', "divider"),
    "a control that Tab skips": (r'<select id="which"', '<select tabindex="-1" id="which"', "Tab does not reach"),
    "a row that is another's": (r'<tr data-row="1"', '<tr data-row="2"', "row 2"),
}


def controls(browser, report):
    faults = []
    for name, (pattern, replacement, expected) in CONTROLS.items():
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "report"
            shutil.copytree(report, copy)
            text = (copy / "index.html").read_text()
            # Ours is the last script; the chart library comes before.
            at = [match for match in re.finditer(pattern, text)]
            if not at:
                faults.append(f"control: nothing to break for {name}")
                continue
            match = at[-1] if pattern.startswith(("divider", "addEvent", "</")) else at[0]
            if name == "an error that moves nothing":
                match = next(one for one in at if text.rfind("data-measure", 0, one.start()) > one.start() - 200)
            (copy / "index.html").write_text(text[: match.start()] + replacement + text[match.end():])
            found = Check(browser, copy).run(until=expected)
            if any(expected in fault for fault in found):
                print(f"control: {name}: found")
            else:
                faults.append(f"control: {name}: not found, but {found[:3]}")
    return faults


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("report", type=Path)
    arguments.add_argument("--screenshots", type=Path, help="where screenshots go")
    arguments.add_argument("--controls", action="store_true", help="also break copies, which must be found faulty")
    arguments = arguments.parse_args()
    if not (arguments.report / "index.html").is_file():
        sys.exit(f"{arguments.report}: no report: index.html is missing")
    try:
        from playwright.sync_api import Error, sync_playwright
    except ImportError:
        print("skipped: Playwright is not installed (pip install playwright)")
        sys.exit(SKIPPED)
    names = ("chromium", "chromium-browser", "google-chrome")
    system = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, names)), None)
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=system, args=["--no-sandbox"])
        except Error as error:
            print(f"skipped: no Chromium can be started: {str(error).splitlines()[0]}")
            sys.exit(SKIPPED)
        faults = Check(browser, arguments.report, arguments.screenshots).run()
        if arguments.controls and not faults:
            faults = controls(browser, arguments.report)
        browser.close()
    for fault in faults:
        print(f"fault: {fault}")
    if not faults:
        print(f"{arguments.report}: no fault")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
