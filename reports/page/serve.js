// The page beside its server (pendular serve): asks once a second for the state of the study, takes over new
// results without losing the switches, sends recordings that are dropped on it, adds and removes effects.

class Served {
  constructor() {
    this.token = location.pathname.split("/")[1];
    this.events = 0;
    this.changing = false;
    this.offerChanges();
    this.acceptFiles();
    this.follow();
  }
  get shown() { return Number(document.getElementById("results").dataset.version); }

  async follow() {
    for (;;) {
      try {
        const answer = await fetch("state");
        if (!answer.ok) throw new Error(await answer.text());
        const state = await answer.json();
        this.show(state);
        if (state.version !== this.shown) await this.takeOver();
      } catch (error) {
        document.getElementById("status").textContent = "Pendular does not answer: these results do not follow the study. Start 'pendular serve' again and open its new address.";
        document.getElementById("share").hidden = true;
      }
      await new Promise(resolve => setTimeout(resolve, 1000));
    }
  }

  show(state) {
    const share = document.getElementById("share"), trouble = document.getElementById("trouble");
    const made = state.made ? `Results of ${state.made}.` : "";
    this.write("status", `${state.working ? state.sentence : "The page follows the study's files."} ${made}`);
    share.hidden = !state.working;
    if (state.share === null) share.removeAttribute("value"); else share.value = state.share;
    this.write("trouble", state.trouble && state.version > 0 ? `${state.trouble}. Until this is mended, the page shows the last good results.` : state.trouble);
    trouble.hidden = state.trouble === "";
    this.changing = state.changing;
    for (const button of document.querySelectorAll("button[data-change]")) button.disabled = state.changing;
    for (const event of state.events.filter(e => e.number > this.events)) {
      html("li", {}, document.getElementById("events"), `${event.time} ${event.text}`);
      if (event.of_effect) this.answer(event.text, event.ok);
      this.events = event.number;
    }
  }
  // Texts are replaced only where they differ, so that screen readers read each once.
  write(id, text) {
    const element = document.getElementById(id);
    if (element.textContent !== text) element.textContent = text;
  }
  answer(text, ok) {
    const place = document.getElementById("answers");
    html("p", {class: ok ? "answer" : "answer warning"}, place, text);
    while (place.children.length > 4) place.firstChild.remove();
  }

  // Replaces the results by those of the server. Switches that the reader moved stay as they are.
  async takeOver() {
    const answer = await fetch("./");
    if (!answer.ok) return;
    const next = new DOMParser().parseFromString(await answer.text(), "text/html").getElementById("results");
    if (!next) return;
    const moved = new Map(), before = window.page, focus = document.activeElement;
    if (before) before.data.switches.forEach((s, k) => { if (before.isOn(k) !== ((before.data.current >> k & 1) === 1)) moved.set(s.name, before.isOn(k)); });
    const open = [...document.querySelectorAll("#results details")].map(details => details.open);
    const effect = focus && focus.getAttribute("data-effect"), changed = focus && focus.getAttribute("data-change");
    document.getElementById("results").replaceWith(document.adoptNode(next));
    showData();
    if (window.page) this.restore(moved);
    document.querySelectorAll("#results details").forEach((details, k) => { details.open = open[k] || false; });
    this.offerChanges();
    const again = [...document.querySelectorAll("[data-effect], [data-change]")].find(e => (effect && e.getAttribute("data-effect") === effect) || (changed && e.getAttribute("data-change") === changed));
    if (again) again.focus();
  }
  restore(moved) {
    window.page.data.switches.forEach((s, k) => {
      if (moved.has(s.name) && moved.get(s.name) !== window.page.isOn(k)) window.page.flip(k, moved.get(s.name));
    });
  }

  offerChanges() {
    const {page} = window;
    if (!page) return;
    page.boxes.forEach(({box}, k) => {
      const {name} = page.data.switches[k];
      this.offer(name, (page.data.current >> k & 1) === 1, box.parentElement);
    });
    // Effects of the study beyond the number of switches.
    const always = document.getElementById("always");
    for (const name of [...page.data.always].reverse()) this.offer(name, true, always, ": " + name);
  }
  // Puts a button after `place` that adds an effect to the study or removes a listed one.
  offer(name, listed, place, more = "") {
    const text = listed ? "Remove from the study" : "Add to the study";
    const button = html("button", {type: "button", "data-change": name, "aria-label": `${text}: ${name}`}, null, text + more);
    button.disabled = this.changing;
    button.addEventListener("click", () => this.change(listed ? "drop" : "add", name));
    place.after(button);
  }
  async change(action, effect) {
    await this.post(`change?action=${action}&effect=${encodeURIComponent(effect)}`, "");
  }

  acceptFiles() {
    const place = document.getElementById("drop"), chosen = document.getElementById("files");
    const over = event => {
      if (![...event.dataTransfer.types].includes("Files")) return;
      event.preventDefault();
      place.classList.add("over");
    };
    addEventListener("dragenter", over);
    addEventListener("dragover", over);
    addEventListener("dragleave", event => { if (!event.relatedTarget) place.classList.remove("over"); });
    addEventListener("drop", event => {
      event.preventDefault();
      place.classList.remove("over");
      this.send([...event.dataTransfer.files]);
    });
    chosen.addEventListener("change", async () => {
      await this.send([...chosen.files]);
      chosen.value = "";
    });
  }
  async send(files) {
    for (const file of files) await this.post(`recording?name=${encodeURIComponent(file.name)}`, file);
  }
  async post(path, body) {
    try {
      const answer = await fetch(path, {method: "POST", headers: {"X-Pendular-Token": this.token, "Content-Type": "application/octet-stream"}, body});
      this.answer(await answer.text(), answer.ok);
    } catch (error) {
      this.answer(`${path.split("?")[0]}: Pendular did not answer (${error.message}).`, false);
    }
  }
}
window.served = new Served();
