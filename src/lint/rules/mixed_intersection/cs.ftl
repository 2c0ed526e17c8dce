W308 = průnik { $id } nevypadá všude stejně: { $first } { $first-id } a { $second } { $second-id } se liší ({ $aspects ->
    [texture] barva
    [optics] optická vlastnost
    [index] index lomu
    [texture-optics] barva a optická vlastnost
    [texture-index] barva a index lomu
    [optics-index] optická vlastnost a index lomu
   *[all] barva, optická vlastnost a index lomu
})
    .label = výsledku { $id } není nic přiřazeno
    .note = každá část povrchu má vlastnosti toho operandu, ze kterého pochází
    .help = má-li celý povrch vypadat stejně, přiřaďte vlastnosti výsledku: `{ $id } -299 TEXTURA OPTIKA`
    .fix = přiřadit { $id } tytéž vlastnosti, jaké má { $source }
