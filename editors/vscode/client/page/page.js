// SPDX-License-Identifier: Apache-2.0
// The page of the preview: shows the picture that it receives, and reports the element on which the user clicked.
"use strict";

(() => {
    const host = acquireVsCodeApi();
    const { nonce } = document.currentScript;
    const part = (id) => document.getElementById(id);
    const view = part("view");
    const least = 0.1;
    const most = 8;

    /** The state that survives while the page is hidden, and after a restart. */
    const state = { zoom: 1, left: 0, top: 0, ...host.getState() };
    /** Width and height of the picture at 100 %. */
    let natural;

    function save() {
        Object.assign(state, { left: view.scrollLeft, top: view.scrollTop });
        host.setState(state);
    }

    function resize() {
        const svg = view.querySelector("svg");
        if (svg === null) return;
        svg.setAttribute("width", natural.width * state.zoom);
        svg.setAttribute("height", natural.height * state.zoom);
        part("zoom").textContent = `${Math.round(state.zoom * 100)} %`;
    }

    /** Keeps the point of the picture at `x`, `y` of the view in its place. */
    function zoomTo(wanted, x = view.clientWidth / 2, y = view.clientHeight / 2) {
        const zoom = Math.min(most, Math.max(least, wanted));
        const factor = zoom / state.zoom;
        const left = (view.scrollLeft + x) * factor - x;
        const top = (view.scrollTop + y) * factor - y;
        state.zoom = zoom;
        resize();
        view.scrollTo(left, top);
        save();
    }

    function highlight(id) {
        for (const each of view.querySelectorAll(".current")) each.classList.remove("current");
        if (typeof id !== "string") return;
        for (const each of view.querySelectorAll(`[data-element="${CSS.escape(id)}"]`)) each.classList.add("current");
    }

    /** The picture as nodes of this page; undefined if the text is not a picture. */
    function nodesOf(text) {
        // The only style comes from the server, which escapes names. The policy of the page applies while it is parsed.
        const allowed = text.replace("<style>", `<style nonce="${nonce}">`);
        const read = new DOMParser().parseFromString(allowed, "image/svg+xml").documentElement;
        return read.localName === "svg" ? document.importNode(read, true) : undefined;
    }

    /** Replaces the picture. Keeps the zoom, and for the same component also the scroll position. */
    function show({ svg: text, stale, component, uri, id, note }) {
        const svg = text === undefined ? undefined : nodesOf(text);
        if (svg !== undefined) {
            const same = component === state.component && uri === state.uri;
            const { left, top } = same ? state : { left: 0, top: 0 };
            const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
            natural = { width, height };
            Object.assign(state, { component, uri });
            view.replaceChildren(svg);
            resize();
            view.scrollTo(left, top);
            save();
        }
        view.classList.toggle("stale", stale === true);
        part("note").textContent = note ?? (stale ? "The text has mistakes of syntax: this is the last diagram before them." : "");
        highlight(id);
    }

    window.addEventListener("message", ({ data }) => {
        if (data?.type === "picture") show(data);
        if (data?.type === "highlight") highlight(data.id);
    });
    view.addEventListener("click", ({ target }) => {
        const element = target.closest("[data-element]");
        if (element !== null) host.postMessage({ type: "reveal", id: element.dataset.element });
    });
    view.addEventListener(
        "wheel",
        (event) => {
            if (!event.ctrlKey) return;
            event.preventDefault();
            const { left, top } = view.getBoundingClientRect();
            zoomTo(state.zoom * Math.exp(-event.deltaY / 300), event.clientX - left, event.clientY - top);
        },
        { passive: false },
    );
    view.addEventListener("scroll", save);
    const step = 1.25;
    part("smaller").addEventListener("click", () => zoomTo(state.zoom / step));
    part("larger").addEventListener("click", () => zoomTo(state.zoom * step));
    part("whole").addEventListener("click", () => zoomTo(1));
    part("fit").addEventListener("click", () => {
        if (natural !== undefined) zoomTo(Math.min(view.clientWidth / natural.width, view.clientHeight / natural.height));
    });
    host.postMessage({ type: "ready" });
})();
