import "./picture.js";
import { drawPlots } from "./plots.js";
import { drawScene } from "./scene.js";

const data = JSON.parse(document.getElementById("report-data").textContent);
drawPlots(data);
drawScene(data);
