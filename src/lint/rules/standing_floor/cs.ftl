W343 = obdélník { $id } je podle komentáře podlaha, ale stojí svisle
    .label = leží v rovině z = 0 a nic ho neotáčí
    .help = obdélník má meze v x a y: vodorovný je až po rotaci kolem osy x
    .fix = položit ho: přidat `{ $line }`
