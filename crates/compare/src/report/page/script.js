"use strict";
(() => {
  const root = document.documentElement;
  const onPaper = matchMedia("print");
  const color = (name) => getComputedStyle(root).getPropertyValue(name).trim();
  root.classList.add("js");

  // Charts: drawn when they come into sight, and again in other colours.

  const charts = new Map();
  for (const source of document.querySelectorAll("script[data-chart]")) {
    const chart = JSON.parse(source.textContent);
    chart.element = document.getElementById(source.dataset.chart);
    chart.measure = chart.first;
    charts.set(source.dataset.chart, chart);
  }

  const draw = (chart) => {
    const measure = chart.measures?.[chart.measure];
    const inColor = (trace, at) => {
      const index = chart.colors[at];
      const own = color(index === null ? "--soft" : `--series-${index}`);
      const drawn = { ...trace, ...measure?.traces[at], textfont: { color: color("--ink"), size: 12 } };
      for (const part of ["marker", "line", "error_x", "error_y"]) {
        if (drawn[part]) drawn[part] = { ...drawn[part], color: own };
      }
      return drawn;
    };
    const onAxis = (axis, words) => ({
      ...axis,
      gridcolor: color("--rule"),
      linecolor: color("--soft"),
      title: words === undefined ? axis.title : { text: words },
    });
    const { data, layout, config } = chart.plot;
    const inColors = {
      ...layout,
      font: { color: color("--soft"), family: "system-ui, sans-serif" },
      hoverlabel: { bgcolor: color("--tint"), bordercolor: color("--soft"), font: { color: color("--ink") } },
      modebar: { bgcolor: "rgba(0,0,0,0)", color: color("--soft"), activecolor: color("--ink") },
      paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: "rgba(0,0,0,0)",
      xaxis: onAxis(layout.xaxis),
      yaxis: onAxis(layout.yaxis, measure?.axis),
      uirevision: chart.measure,
    };
    chart.isDrawn = true;
    Plotly.react(chart.element, data.map(inColor), inColors, config);
  };

  const inSight = new IntersectionObserver(
    (entries) => {
      for (const entry of entries.filter((entry) => entry.isIntersecting)) {
        const chart = charts.get(entry.target.id);
        if (!chart.isDrawn) draw(chart);
      }
    },
    { rootMargin: "300px" },
  );
  charts.forEach((chart) => inSight.observe(chart.element));

  const drawAll = () => charts.forEach((chart) => chart.isDrawn && draw(chart));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);

  // One front per error: the figure, the sentence and the table follow the choice.

  for (const choice of document.querySelectorAll("select[data-measure]")) {
    choice.addEventListener("change", () => {
      const chart = charts.get(choice.dataset.measure);
      const answer = choice.closest(".answer");
      chart.measure = Number(choice.value);
      const { sentence, front, values } = chart.measures[chart.measure];
      answer.querySelector(".sentence").textContent = sentence;
      answer.querySelector("th.error").textContent = choice.selectedOptions[0].textContent;
      const body = answer.querySelector("table.front tbody");
      const rows = new Map([...body.rows].map((row) => [Number(row.dataset.row), row]));
      rows.forEach((row, number) => {
        row.hidden = !front.includes(number);
        const [value, interval] = values[number];
        row.querySelector(".error .value").textContent = value ?? "–";
        row.querySelector(".error .interval").textContent = interval;
      });
      front.forEach((number) => body.append(rows.get(number)));
      draw(chart);
    });
  }

  // One answer at a time.

  const which = document.getElementById("which");
  const showChosen = () => {
    for (const answer of document.querySelectorAll(".answer")) {
      answer.hidden = which !== null && answer.id !== which.value;
    }
  };
  which?.addEventListener("change", showChosen);
  showChosen();

  // Pictures against the truth.

  for (const divider of document.querySelectorAll(".pair input")) {
    const move = () => {
      divider.parentElement.style.setProperty("--at", `${divider.value}%`);
      divider.setAttribute("aria-valuetext", `${divider.value} % drawn`);
    };
    divider.addEventListener("input", move);
    move();
  }

  // Tables that are wider than the page can be scrolled by keyboard.

  const sizes = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
      else target.removeAttribute("tabindex");
    }
  });
  document.querySelectorAll(".scroll").forEach((table) => sizes.observe(table));

  // A link to a method opens it.

  const openTarget = () => {
    const target = location.hash.length > 1 && document.getElementById(location.hash.slice(1));
    if (target instanceof HTMLDetailsElement) target.open = true;
  };
  addEventListener("hashchange", openTarget);
  openTarget();

  // Paper shows everything, in the colours of light mode.

  let isOnPaper = false;
  let closed = [];
  const toPaper = () => {
    if (isOnPaper) return;
    isOnPaper = true;
    document.querySelectorAll(".answer").forEach((answer) => { answer.hidden = false; });
    closed = [...document.querySelectorAll("details:not([open])")];
    closed.forEach((details) => { details.open = true; });
    document.querySelectorAll("img[loading]").forEach((image) => { image.loading = "eager"; });
    charts.forEach(draw);
  };
  const toScreen = () => {
    if (!isOnPaper) return;
    isOnPaper = false;
    showChosen();
    closed.forEach((details) => { details.open = false; });
    drawAll();
  };
  onPaper.addEventListener("change", () => (onPaper.matches ? toPaper() : toScreen()));
  addEventListener("beforeprint", toPaper);
  addEventListener("afterprint", toScreen);
})();
